set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.2471:37.9424]
set yrange [3.60624:1771.42]
set title 'Sheet hung by two corners, 128 × 128 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=16; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=16; Fibres and sets iterations=4; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.353 1107.14 "iterations=1"
0.47 1099.37 "iterations=3"
0.684 1088.79 "iterations=7"
1.168 1079.65 "iterations=15"
2.153 1074.84 "iterations=31"
4.108 1065.77 "iterations=63"
7.307 1013.14 "iterations=127"
14.242 866.02 "iterations=255"
END
$curve1 << END
0.743 1049.93 "iterations=8"
1.248 1028.73 "iterations=16"
4.124 933.993 "iterations=64"
END
$curve2 << END
0.555 1106.08 "iterations=1"
0.877 1076.23 "iterations=7"
2.305 977.737 "iterations=31"
7.929 703.511 "iterations=127"
END
$curve3 << END
0.534 1082.99 "iterations=4"
0.765 1074.44 "iterations=8"
1.263 1000.33 "iterations=16"
2.263 630.761 "iterations=32"
4.177 436.77 "iterations=64"
8.111 172.152 "iterations=128"
END
$curve4 << END
0.754 1078.78 "iterations=4"
1.245 1072.58 "iterations=8"
2.211 969.547 "iterations=16"
4.101 646.679 "iterations=32"
7.712 375.078 "iterations=64"
14.943 134.297 "iterations=128"
END
$curve5 << END
1.366 110.1 "iterations=1"
2.303 7.55941 "iterations=2"
3.368 7.87101 "iterations=4"
4.949 7.75815 "iterations=8"
END
$curve6 << END
1.851 12.465 "passes=2 iterations=1"
2.325 9.70741 "passes=2 iterations=2"
2.406 15.7892 "passes=3 iterations=1"
2.973 7.92509 "passes=2 iterations=4"
3.017 6.21337 "passes=3 iterations=2"
3.293 8.68965 "passes=4 iterations=1"
3.67 5.77253 "passes=4 iterations=2"
3.711 7.52803 "passes=3 iterations=4"
3.961 7.87117 "passes=2 iterations=6"
4.449 7.15228 "passes=6 iterations=1"
4.503 7.39958 "passes=3 iterations=6"
4.702 6.21217 "passes=4 iterations=4"
5.063 5.2828 "passes=6 iterations=2"
5.672 6.29876 "passes=8 iterations=1"
6.166 5.15177 "passes=8 iterations=2"
END
$curve7 << END
2.709 51.0486 "passes=1 iterations=2"
2.73 33.1585 "passes=2 iterations=2"
3.15 30.6811 "passes=3 iterations=2"
3.63 25.9785 "passes=4 iterations=2"
4.375 29.0725 "passes=4 iterations=4"
5.667 30.3487 "passes=6 iterations=4"
END
$curve8 << END
10.339 159.105 "passes=2 iterations=2"
10.617 153.123 "passes=1 iterations=2"
13.255 173.964 "passes=3 iterations=2"
17.696 164.059 "passes=4 iterations=2"
23.714 165.836 "passes=6 iterations=2"
END
$default << END
3.15 30.6811 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-128-own-1s.svg'
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
set output 'accuracy-hanging-128-own-1s.png'
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
