set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.325545:23.0805]
set xtics (0.5, 1, 2, 5, 10, 20)
set yrange [2.19134:1886.29]
set title 'Sheet hung by two corners, 128 × 128 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1; Fibres and sets iterations=4' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.465065 1089.74 "iterations=1"
0.591411 1108.76 "iterations=3"
0.852744 1149.57 "iterations=7"
1.23069 1166.74 "iterations=15"
2.048 1165.68 "iterations=31"
3.60433 1136.28 "iterations=63"
7.21014 998.678 "iterations=127"
14.4253 828.154 "iterations=255"
END
$curve1 << END
0.502672 1151.85 "iterations=2"
0.833343 1163.39 "iterations=8"
1.27275 1178.93 "iterations=16"
4.04322 1123.37 "iterations=64"
END
$curve2 << END
0.59482 983.613 "iterations=1"
0.913963 846.164 "iterations=7"
2.32295 729.333 "iterations=31"
7.78924 617.403 "iterations=127"
END
$curve3 << END
0.649131 1088.36 "iterations=4"
0.908507 1066.91 "iterations=8"
1.44532 951.486 "iterations=16"
2.35863 690.353 "iterations=32"
4.0759 453.076 "iterations=64"
7.77975 186.203 "iterations=128"
END
$curve4 << END
0.755605 1121.07 "iterations=4"
1.06146 1094.29 "iterations=8"
1.90618 949.921 "iterations=16"
3.51245 667.722 "iterations=32"
6.6772 414.765 "iterations=64"
13.1103 174.888 "iterations=128"
END
$curve5 << END
1.43931 139.877 "iterations=1"
2.00019 42.7502 "iterations=2"
2.86988 26.3203 "iterations=3"
3.2641 23.756 "iterations=4"
4.32998 20.5292 "iterations=6"
5.82313 16.119 "iterations=8"
9.01844 18.1511 "iterations=12"
10.7708 12.3494 "iterations=16"
END
$curve6 << END
1.15741 113.681 "iterations=1"
1.60397 42.908 "iterations=2"
2.54307 31.678 "iterations=4"
4.21056 52.8786 "iterations=8"
END
$curve7 << END
1.8752 35.6642 "passes=2 iterations=1"
2.46583 17.5854 "passes=2 iterations=2"
2.60058 24.8958 "passes=3 iterations=1"
2.94979 9.97224 "passes=3 iterations=2"
3.19455 7.87578 "passes=2 iterations=4"
3.48598 7.21681 "passes=4 iterations=2"
3.48656 16.0925 "passes=4 iterations=1"
3.93078 6.95032 "passes=3 iterations=4"
4.15695 5.92657 "passes=2 iterations=6"
4.22556 4.87534 "passes=4 iterations=4"
4.65287 10.0032 "passes=6 iterations=1"
4.781 3.13049 "passes=3 iterations=6"
4.87463 5.98642 "passes=6 iterations=2"
5.84126 6.95657 "passes=8 iterations=1"
6.02405 3.22939 "passes=8 iterations=2"
END
$curve8 << END
1.59854 47.4023 "passes=1 iterations=2"
2.2398 39.3725 "passes=2 iterations=2"
2.86257 26.5897 "passes=3 iterations=2"
3.52377 24.1524 "passes=4 iterations=2"
4.1946 30.1074 "passes=4 iterations=4"
5.58354 31.8166 "passes=6 iterations=4"
END
$curve9 << END
3.8042 44.5495 "passes=1 iterations=2"
5.22687 30.5331 "passes=2 iterations=2"
7.05957 21.5235 "passes=3 iterations=2"
8.83988 15.1514 "passes=4 iterations=2"
11.7445 10.7793 "passes=6 iterations=2"
END
$default << END
2.94979 9.97224 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-128-own-1s.svg'
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
set output 'accuracy-hanging-128-own-1s.png'
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
