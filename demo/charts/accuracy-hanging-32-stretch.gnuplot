set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0168:26.4992]
set yrange [0.493837:5869.12]
set title 'Sheet hung by two corners, 32 × 32 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=47; Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.024 235.545 "iterations=1"
0.03 330.709 "iterations=3"
0.042 147.956 "iterations=7"
0.065 76.6141 "iterations=15"
0.112 42.2316 "iterations=31"
0.208 32.092 "iterations=63"
0.396 9.39345 "iterations=127"
0.831 9.26471 "iterations=255"
END
$curve1 << END
0.027 572.846 "iterations=2"
0.045 296.783 "iterations=8"
0.068 191.447 "iterations=16"
0.209 137.801 "iterations=64"
END
$curve2 << END
0.037 34.2933 "iterations=1"
0.055 4.48142 "iterations=7"
0.124 4.55301 "iterations=31"
0.408 2.96192 "iterations=127"
END
$curve3 << END
0.077 101.465 "iterations=7 substeps=2"
0.152 0.705482 "iterations=7 substeps=4"
0.296 8.67429 "iterations=7 substeps=8"
0.583 7.00625 "iterations=7 substeps=16"
END
$curve4 << END
0.034 102.774 "iterations=4"
0.046 46.1036 "iterations=8"
0.071 7.28048 "iterations=16"
0.124 8.30216 "iterations=32"
0.227 7.72282 "iterations=64"
0.44 7.17079 "iterations=128"
END
$curve5 << END
0.045 104.401 "iterations=4"
0.071 24.6333 "iterations=8"
0.123 14.4995 "iterations=16"
0.23 7.90481 "iterations=32"
0.439 7.09248 "iterations=64"
0.885 7.29831 "iterations=128"
END
$curve6 << END
0.068 8.06893 "iterations=1"
0.12 7.60596 "iterations=2"
0.162 7.57799 "iterations=4"
0.243 7.42081 "iterations=8"
END
$curve7 << END
0.091 8.24572 "passes=2 iterations=1"
0.11 7.68394 "passes=2 iterations=2"
0.12 7.75174 "passes=3 iterations=1"
0.145 7.75341 "passes=3 iterations=2"
0.146 7.4385 "passes=2 iterations=4"
0.154 7.77293 "passes=4 iterations=1"
0.177 7.57263 "passes=4 iterations=2"
0.179 7.55578 "passes=3 iterations=4"
0.186 7.33552 "passes=2 iterations=6"
0.217 7.52247 "passes=4 iterations=4"
0.217 7.6187 "passes=6 iterations=1"
0.224 7.56885 "passes=3 iterations=6"
0.236 7.57042 "passes=6 iterations=2"
0.277 7.64294 "passes=8 iterations=1"
0.301 7.59006 "passes=8 iterations=2"
END
$curve8 << END
0.13 8.22827 "passes=1 substeps=2"
0.253 7.66242 "passes=1 substeps=4"
0.511 7.48632 "passes=1 substeps=8"
1.045 6.50356 "passes=1 substeps=16"
END
$curve9 << END
0.116 7.4643 "passes=2 iterations=2"
0.123 8.84714 "passes=1 iterations=2"
0.15 3.8945 "passes=3 iterations=2"
0.179 4.31448 "passes=4 iterations=2"
0.217 4.27253 "passes=4 iterations=4"
0.28 4.63936 "passes=6 iterations=4"
END
$curve10 << END
0.281 5.55638 "passes=3 substeps=2"
0.576 4.71535 "passes=3 substeps=4"
1.201 4.48106 "passes=3 substeps=8"
END
$curve11 << END
0.324 7.57548 "passes=2 iterations=2"
0.355 7.65329 "passes=1 iterations=2"
0.42 7.87039 "passes=3 iterations=2"
0.521 7.94347 "passes=4 iterations=2"
0.719 7.97207 "passes=6 iterations=2"
END
$curve12 << END
0.051 3668.2 "substeps=1"
0.096 1069.8 "substeps=2"
0.187 140.585 "substeps=4"
0.37 18.4973 "substeps=8"
0.735 5.69081 "substeps=16"
1.485 3.92418 "substeps=32"
2.997 5.58488 "substeps=64"
END
$curve13 << END
0.082 1013.63 "iterations=4"
0.205 121.335 "iterations=16"
0.726 24.9797 "iterations=64"
END
$curve14 << END
0.094 789.815 "iterations=4"
0.253 48.2487 "iterations=16"
0.896 20.8963 "iterations=64"
END
$curve15 << END
0.201 79.8166 "iterations=1 substeps=4"
0.788 7.33028 "iterations=1 substeps=16"
3.208 6.64462 "iterations=1 substeps=64"
END
$curve16 << END
0.444 4.951 "substeps=47"
0.676 4.60498 "substeps=71"
1.3 5.89326 "substeps=142"
END
$curve17 << END
1.958 3.17768 "substeps=142"
END
$curve18 << END
16.562 7.29977 "one factorisation a step"
END
$default << END
0.15 3.8945 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-32-stretch.svg'
plot 5.11611 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-32-stretch.png'
plot 5.11611 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
