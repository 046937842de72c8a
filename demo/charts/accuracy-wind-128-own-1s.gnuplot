set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.2947:38.584]
set yrange [1.39893:845.395]
set title 'Hung sheet in wind, 128 × 128 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1; Fibres and sets iterations=4'."\n".' Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.421 227.386 "iterations=1"
0.539 195.722 "iterations=3"
0.818 145.091 "iterations=7"
1.36 85.4503 "iterations=15"
2.301 71.4633 "iterations=31"
4.299 100.263 "iterations=63"
8.301 99.5999 "iterations=127"
16.198 57.7642 "iterations=255"
END
$curve1 << END
0.857 519.102 "iterations=8"
1.376 528.372 "iterations=16"
4.453 211.142 "iterations=64"
END
$curve2 << END
0.636 227.811 "iterations=1"
0.982 147.884 "iterations=7"
2.485 37.5806 "iterations=31"
8.394 85.1767 "iterations=127"
END
$curve3 << END
0.651 109.015 "iterations=4"
0.903 80.2098 "iterations=8"
1.386 101.108 "iterations=16"
2.474 34.8999 "iterations=32"
4.555 18.0487 "iterations=64"
8.701 19.0374 "iterations=128"
END
$curve4 << END
0.778 83.921 "iterations=4"
1.26 94.0455 "iterations=8"
2.296 84.8055 "iterations=16"
4.204 28.948 "iterations=32"
7.855 17.0497 "iterations=64"
15.152 16.1422 "iterations=128"
END
$curve5 << END
1.336 23.7032 "iterations=1"
1.53 25.6868 "iterations=2"
2.342 11.3456 "iterations=4"
4.037 10.4031 "iterations=8"
END
$curve6 << END
1.759 25.9955 "passes=2 iterations=1"
2.314 14.5594 "passes=2 iterations=2"
2.679 19.8145 "passes=3 iterations=1"
2.901 4.68469 "passes=2 iterations=4"
3.095 3.54249 "passes=3 iterations=2"
3.248 6.73046 "passes=4 iterations=1"
3.951 4.4648 "passes=3 iterations=4"
4.003 2.16579 "passes=4 iterations=2"
4.025 5.78224 "passes=2 iterations=6"
4.803 3.28508 "passes=4 iterations=4"
4.944 5.18963 "passes=3 iterations=6"
5.057 1.99847 "passes=6 iterations=2"
5.08 3.42621 "passes=6 iterations=1"
6.149 2.28826 "passes=8 iterations=1"
6.338 2.10062 "passes=8 iterations=2"
END
$curve7 << END
2.658 25.5989 "passes=1 iterations=2"
3.163 21.3791 "passes=2 iterations=2"
3.832 25.2002 "passes=3 iterations=2"
4.157 5.72219 "passes=4 iterations=2"
5.042 5.37655 "passes=4 iterations=4"
6.236 4.15679 "passes=6 iterations=4"
END
$curve8 << END
7.395 34.8977 "passes=1 iterations=2"
11.856 25.7293 "passes=2 iterations=2"
15.543 24.0598 "passes=3 iterations=2"
17.718 20.5838 "passes=4 iterations=2"
24.115 11.1744 "passes=6 iterations=2"
END
$default << END
3.832 25.2002 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-128-own-1s.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-128-own-1s.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
