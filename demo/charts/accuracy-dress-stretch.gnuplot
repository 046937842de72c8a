set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0926023:421.325]
set yrange [16.2518:189.374]
set ytics (20, 50, 100)
set title 'Dress hung by its neck, 4589 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 5
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 8572a2e; κ = 1504; weft_study accuracy, then weft_study plot' at screen 0.012, screen 0.022 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.141893 37.6397 "iterations=1"
0.196896 34.6504 "iterations=3"
0.28152 36.8598 "iterations=7"
0.500183 34.2575 "iterations=15"
0.940942 27.1653 "iterations=31"
1.72538 26.2741 "iterations=63"
3.43085 24.7129 "iterations=127"
6.39036 23.2169 "iterations=255"
END
$curve1 << END
0.161659 118.359 "iterations=2"
0.318181 84.6995 "iterations=8"
0.475929 61.4685 "iterations=16"
1.75185 27.4117 "iterations=64"
END
$curve2 << END
0.149006 37.6397 "iterations=1"
0.308884 36.8598 "iterations=7"
0.839488 27.1653 "iterations=31"
3.34705 24.7129 "iterations=127"
END
$curve3 << END
0.517098 25.9386 "iterations=7 substeps=2"
1.09758 23.2169 "iterations=7 substeps=4"
2.21648 23.2169 "iterations=7 substeps=8"
4.32204 23.2169 "iterations=7 substeps=16"
END
$curve4 << END
0.233799 33.5412 "iterations=4"
0.331154 38.2638 "iterations=8"
0.523045 39.4668 "iterations=16"
0.937693 23.2169 "iterations=32"
1.72742 23.2169 "iterations=64"
3.4434 23.2169 "iterations=128"
END
$curve5 << END
0.295388 34.0332 "iterations=4"
0.472611 28.9951 "iterations=8"
0.840285 23.2169 "iterations=16"
1.40242 23.2169 "iterations=32"
2.72744 23.2169 "iterations=64"
5.33405 23.2169 "iterations=128"
END
$curve6 << END
0.393447 23.2169 "iterations=1"
0.584592 23.2169 "iterations=2"
0.924006 23.2169 "iterations=3"
1.17069 23.2169 "iterations=4"
1.67323 23.2169 "iterations=6"
2.10628 23.2169 "iterations=8"
2.63534 23.2169 "iterations=12"
3.4395 23.2169 "iterations=16"
END
$curve7 << END
0.289249 23.2169 "iterations=1"
0.404086 23.2169 "iterations=2"
0.619482 23.2169 "iterations=4"
1.09147 23.2169 "iterations=8"
END
$curve8 << END
0.468543 23.2169 "passes=2 iterations=1"
0.586362 23.2169 "passes=2 iterations=2"
0.673047 23.2169 "passes=3 iterations=1"
0.753214 23.2169 "passes=3 iterations=2"
0.82644 23.2169 "passes=2 iterations=4"
0.898871 23.2169 "passes=4 iterations=1"
0.929617 23.2169 "passes=4 iterations=2"
1.06301 23.2169 "passes=2 iterations=6"
1.12813 23.2169 "passes=4 iterations=4"
1.20038 23.2169 "passes=3 iterations=4"
1.23127 23.2169 "passes=3 iterations=6"
1.34811 23.2169 "passes=6 iterations=1"
1.48793 23.2169 "passes=6 iterations=2"
1.59499 23.2169 "passes=8 iterations=2"
1.70153 23.2169 "passes=8 iterations=1"
END
$curve9 << END
0.653642 23.2169 "passes=1 substeps=2"
1.25719 23.2169 "passes=1 substeps=4"
2.36402 23.2169 "passes=1 substeps=8"
4.54829 23.2169 "passes=1 substeps=16"
END
$curve10 << END
0.132289 70.2794 "substeps=1"
0.249947 60.8335 "substeps=2"
0.479451 52.9586 "substeps=4"
0.984399 48.4508 "substeps=8"
1.89276 27.4001 "substeps=16"
3.76356 23.2169 "substeps=32"
7.58765 23.2169 "substeps=64"
END
$curve11 << END
0.413114 61.4906 "iterations=4"
1.43704 54.1269 "iterations=16"
5.54176 41.495 "iterations=64"
END
$curve12 << END
0.223833 59.3402 "iterations=1"
0.724123 47.6423 "iterations=4"
2.6884 46.5158 "iterations=16"
10.6584 38.2712 "iterations=64"
END
$curve13 << END
0.868868 42.4693 "iterations=1 substeps=4"
3.46175 23.2169 "iterations=1 substeps=16"
13.1281 23.2169 "iterations=1 substeps=64"
END
$curve14 << END
11.2515 23.2169 "substeps=207"
17.2608 23.2169 "substeps=318"
34.8296 23.2169 "substeps=635"
END
$curve15 << END
15.3887 23.2169 "substeps=207"
47.0981 23.2169 "substeps=635"
END
$curve16 << END
263.328 23.2169 "one factorisation a step"
END
$default << END
0.753214 23.2169 "passes=3 iterations=2"
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
