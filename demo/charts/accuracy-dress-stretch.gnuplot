set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0952371:465.25]
set yrange [16.2518:161.918]
set ytics (20, 50, 100)
set title 'Dress hung by its neck, 4589 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 5
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 1504; weft_study accuracy, then weft_study plot' at screen 0.012, screen 0.022 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.166129 31.2702 "iterations=1"
0.212167 35.9651 "iterations=3"
0.320798 36.6406 "iterations=7"
0.53437 35.3876 "iterations=15"
0.983308 30.7358 "iterations=31"
1.79544 27.0519 "iterations=63"
3.48995 23.3415 "iterations=127"
6.86341 23.2169 "iterations=255"
END
$curve1 << END
0.180147 101.199 "iterations=2"
0.350964 61.1395 "iterations=8"
0.540259 43.825 "iterations=16"
1.75964 27.5143 "iterations=64"
END
$curve2 << END
0.170932 31.2702 "iterations=1"
0.306354 36.6406 "iterations=7"
0.968358 30.7358 "iterations=31"
3.82844 23.3415 "iterations=127"
END
$curve3 << END
0.66159 25.4804 "iterations=7 substeps=2"
1.19202 23.2169 "iterations=7 substeps=4"
2.52254 23.2169 "iterations=7 substeps=8"
4.99381 23.2169 "iterations=7 substeps=16"
END
$curve4 << END
0.256567 35.2998 "iterations=4"
0.385347 42.2265 "iterations=8"
0.607529 24.0084 "iterations=16"
1.08275 23.2169 "iterations=32"
1.88507 23.2169 "iterations=64"
3.36818 23.2169 "iterations=128"
END
$curve5 << END
0.248013 52.9366 "iterations=4"
0.43118 33.347 "iterations=8"
0.850887 23.2169 "iterations=16"
1.60204 23.2169 "iterations=32"
2.90066 23.2169 "iterations=64"
5.80386 23.2169 "iterations=128"
END
$curve6 << END
0.495998 23.2169 "iterations=1"
0.727257 23.2169 "iterations=2"
0.964614 23.2169 "iterations=3"
1.18579 23.2169 "iterations=4"
1.47775 23.2169 "iterations=6"
2.12416 23.2169 "iterations=8"
2.79474 23.2169 "iterations=12"
3.48685 23.2169 "iterations=16"
END
$curve7 << END
0.371682 23.2169 "iterations=1"
0.572012 23.2169 "iterations=2"
0.827046 23.2169 "iterations=4"
1.42937 23.2169 "iterations=8"
END
$curve8 << END
0.652454 23.2169 "passes=2 iterations=1"
0.750901 23.2169 "passes=2 iterations=2"
0.843474 23.2169 "passes=3 iterations=1"
1.0094 23.2169 "passes=3 iterations=2"
1.02497 23.2169 "passes=4 iterations=1"
1.1812 23.2169 "passes=2 iterations=4"
1.19997 23.2169 "passes=4 iterations=2"
1.3097 23.2169 "passes=3 iterations=4"
1.32314 23.2169 "passes=6 iterations=1"
1.37404 23.2169 "passes=2 iterations=6"
1.52683 23.2169 "passes=6 iterations=2"
1.53967 23.2169 "passes=4 iterations=4"
1.58278 23.2169 "passes=3 iterations=6"
1.92689 23.2169 "passes=8 iterations=1"
2.03068 23.2169 "passes=8 iterations=2"
END
$curve9 << END
0.741369 23.2169 "passes=1 substeps=2"
1.39002 23.2169 "passes=1 substeps=4"
2.7793 23.2169 "passes=1 substeps=8"
5.58172 23.2169 "passes=1 substeps=16"
END
$curve10 << END
0.136053 65.8947 "substeps=1"
0.255947 57.8481 "substeps=2"
0.50531 59.6094 "substeps=4"
1.05831 48.7779 "substeps=8"
1.93954 32.5307 "substeps=16"
3.93763 23.2169 "substeps=32"
7.78242 23.2169 "substeps=64"
END
$curve11 << END
0.658992 62.0064 "iterations=4"
1.44161 58.8787 "iterations=16"
5.56128 46.6209 "iterations=64"
END
$curve12 << END
0.286328 58.1447 "iterations=1"
0.938956 48.8733 "iterations=4"
3.71457 47.57 "iterations=16"
14.8642 38.177 "iterations=64"
END
$curve13 << END
1.13165 43.4654 "iterations=1 substeps=4"
4.21802 23.2169 "iterations=1 substeps=16"
17.4435 23.2169 "iterations=1 substeps=64"
END
$curve14 << END
14.0433 23.2169 "substeps=207"
21.5454 23.2169 "substeps=318"
43.4874 23.2169 "substeps=635"
END
$curve15 << END
17.6157 23.2169 "substeps=207"
59.494 23.2169 "substeps=635"
END
$curve16 << END
290.781 23.2169 "one factorisation a step"
END
$default << END
1.0094 23.2169 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-dress-stretch.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-dress-stretch.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
