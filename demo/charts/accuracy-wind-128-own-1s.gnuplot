set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.351627:21.6627]
set xtics (0.5, 1, 2, 5, 10, 20)
set yrange [8.01248:577.093]
set ytics (10, 20, 50, 100, 200, 500)
set title 'Hung sheet in wind, 128 × 128 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1; Fibres and sets iterations=4' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.532151 190.087 "iterations=1"
0.624457 248.392 "iterations=3"
0.851288 282.467 "iterations=7"
1.11066 260.685 "iterations=15"
1.8616 223.354 "iterations=31"
3.34246 143.56 "iterations=63"
6.74611 93.2784 "iterations=127"
12.6151 60.746 "iterations=255"
END
$curve1 << END
0.502324 217.429 "iterations=2"
0.858906 354.802 "iterations=8"
1.34294 360.683 "iterations=16"
3.37405 146.078 "iterations=64"
END
$curve2 << END
0.607507 113.506 "iterations=1"
0.960838 173.898 "iterations=7"
2.01315 160.182 "iterations=31"
7.33546 82.0124 "iterations=127"
END
$curve3 << END
0.71098 142.54 "iterations=4"
0.955551 133.954 "iterations=8"
1.20871 86.0347 "iterations=16"
2.03349 58.0546 "iterations=32"
3.95041 53.4086 "iterations=64"
7.72995 54.7631 "iterations=128"
END
$curve4 << END
0.717732 210.989 "iterations=4"
1.21127 172.193 "iterations=8"
1.98097 72.9552 "iterations=16"
3.51959 60.6565 "iterations=32"
8.0769 52.2903 "iterations=64"
13.5392 57.3464 "iterations=128"
END
$curve5 << END
1.59275 58.3343 "iterations=1"
2.47558 55.1143 "iterations=2"
2.69978 54.2343 "iterations=3"
3.51264 50.5979 "iterations=4"
5.24082 52.1264 "iterations=6"
6.55611 50.9188 "iterations=8"
8.80168 41.4904 "iterations=12"
9.76998 46.4029 "iterations=16"
END
$curve6 << END
1.33703 58.2082 "iterations=1"
1.81937 47.522 "iterations=2"
2.04467 42.5634 "iterations=4"
3.3621 41.2751 "iterations=8"
END
$curve7 << END
2.05344 51.8702 "passes=2 iterations=1"
2.31201 42.3376 "passes=2 iterations=2"
2.43245 47.9688 "passes=3 iterations=1"
2.44172 32.1811 "passes=3 iterations=2"
3.08003 40.6472 "passes=4 iterations=1"
3.2871 22.7839 "passes=2 iterations=6"
3.51468 26.7972 "passes=2 iterations=4"
3.61496 24.2154 "passes=4 iterations=2"
3.67362 28.3809 "passes=6 iterations=1"
3.71596 23.9718 "passes=3 iterations=4"
4.33688 23.8293 "passes=3 iterations=6"
4.36094 21.6593 "passes=4 iterations=4"
4.58679 20.1611 "passes=6 iterations=2"
4.84819 23.0639 "passes=8 iterations=1"
5.08992 19.9734 "passes=8 iterations=2"
END
$curve8 << END
1.69738 41.8784 "passes=1 iterations=2"
2.2008 41.3974 "passes=2 iterations=2"
2.97054 25.7507 "passes=3 iterations=2"
3.25862 20.8971 "passes=4 iterations=2"
3.9926 20.1804 "passes=4 iterations=4"
5.46056 20.9964 "passes=6 iterations=4"
END
$curve9 << END
3.53287 32.7885 "passes=1 iterations=2"
5.59302 25.3296 "passes=2 iterations=2"
6.57077 22.6802 "passes=3 iterations=2"
8.01861 16.6018 "passes=4 iterations=2"
10.5091 11.4464 "passes=6 iterations=2"
END
$default << END
2.44172 32.1811 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-128-own-1s.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-128-own-1s.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
