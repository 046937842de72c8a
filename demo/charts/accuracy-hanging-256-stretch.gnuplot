set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.969255:127.632]
set yrange [6.79536:97728.6]
set title 'Sheet hung by two corners, 256 × 256 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 626c968+; κ = 36409; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=16; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=16; Fibres and sets iterations=4; Fibres and sets iterations=64' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
1.60157 958.657 "iterations=1"
2.05668 970.892 "iterations=3"
3.00878 898.318 "iterations=7"
4.9116 993.041 "iterations=15"
8.13761 988.05 "iterations=31"
15.9449 987.827 "iterations=63"
28.9889 1084.18 "iterations=127"
60.1305 1320.22 "iterations=255"
END
$curve1 << END
1.68607 3300.48 "iterations=2"
3.01666 1095.22 "iterations=8"
4.81886 1228.94 "iterations=16"
15.2838 1070.96 "iterations=64"
END
$curve2 << END
2.16107 38.4855 "iterations=1"
3.54933 20.3472 "iterations=7"
8.37679 9.70766 "iterations=31"
28.4986 10.1592 "iterations=127"
END
$curve3 << END
5.50856 985.751 "iterations=7 substeps=2"
10.8149 1225.77 "iterations=7 substeps=4"
21.3717 1268.18 "iterations=7 substeps=8"
43.1197 898.277 "iterations=7 substeps=16"
END
$curve4 << END
2.3426 334.678 "iterations=4"
3.12025 302.193 "iterations=8"
4.97578 345.792 "iterations=16"
8.85925 348.36 "iterations=32"
15.5253 79.6799 "iterations=64"
30.13 54.2294 "iterations=128"
END
$curve5 << END
2.68719 739.339 "iterations=4"
4.36625 611.869 "iterations=8"
7.48366 639.289 "iterations=16"
14.038 529.209 "iterations=32"
27.6239 41.5606 "iterations=64"
54.6689 44.3481 "iterations=128"
END
$curve6 << END
5.06269 44.5936 "iterations=1"
7.6397 24.2956 "iterations=2"
9.93413 23.3128 "iterations=3"
12.2241 23.1262 "iterations=4"
16.6832 24.1197 "iterations=6"
21.8559 28.5428 "iterations=8"
30.6911 29.1295 "iterations=12"
39.4223 29.3479 "iterations=16"
END
$curve7 << END
4.09369 75.2325 "iterations=1"
5.50249 36.2372 "iterations=2"
9.29893 137.882 "iterations=4"
13.8963 31.0626 "iterations=8"
END
$curve8 << END
6.18065 25.3697 "passes=2 iterations=1"
7.64275 25.7429 "passes=2 iterations=2"
8.32298 27.0031 "passes=3 iterations=1"
9.82728 28.4532 "passes=3 iterations=2"
10.4451 27.9615 "passes=4 iterations=1"
10.5967 27.2075 "passes=2 iterations=4"
11.8479 28.4685 "passes=4 iterations=2"
12.7991 27.924 "passes=3 iterations=4"
13.3542 27.055 "passes=2 iterations=6"
14.7757 27.1408 "passes=4 iterations=4"
15.1221 27.9826 "passes=6 iterations=1"
15.6459 26.7999 "passes=3 iterations=6"
16.592 28.3027 "passes=6 iterations=2"
19.443 28.1191 "passes=8 iterations=1"
20.4397 27.9561 "passes=8 iterations=2"
END
$curve9 << END
7.69578 24.8802 "passes=1 substeps=2"
14.9449 30.3185 "passes=1 substeps=4"
30.2282 29.8461 "passes=1 substeps=8"
60.5766 32.1079 "passes=1 substeps=16"
END
$curve10 << END
5.70723 88.7263 "passes=1 iterations=2"
7.77169 34.2658 "passes=2 iterations=2"
10.1821 28.7986 "passes=3 iterations=2"
12.1162 30.4318 "passes=4 iterations=2"
14.9937 27.5908 "passes=4 iterations=4"
19.5325 25.8872 "passes=6 iterations=4"
END
$curve11 << END
19.7516 25.6205 "passes=3 substeps=2"
39.0259 27.0299 "passes=3 substeps=4"
78.591 26.2607 "passes=3 substeps=8"
END
$curve12 << END
1.38465 61080.4 "substeps=1"
2.01047 52757.3 "substeps=2"
3.79671 43520.9 "substeps=4"
7.53775 29814.5 "substeps=8"
14.743 8911.89 "substeps=16"
29.5906 1227.75 "substeps=32"
58.2467 387.513 "substeps=64"
END
$curve13 << END
3.01893 52943 "iterations=4"
10.6864 43233 "iterations=16"
40.9575 28154.6 "iterations=64"
END
$curve14 << END
79.7699 85.2636 "iterations=1 substeps=64"
END
$default << END
9.82728 28.4532 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-256-stretch.svg'
plot 24.0496 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-256-stretch.png'
plot 24.0496 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
