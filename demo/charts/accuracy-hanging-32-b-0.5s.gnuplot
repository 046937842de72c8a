set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0168:26.4992]
set yrange [0.117954:1329]
set title 'Sheet hung by two corners, 32 × 32 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=47; Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.024 633.963 "iterations=1"
0.027 628.384 "iterations=2"
0.03 597.393 "iterations=3"
0.037 560.217 "iterations=1"
0.045 468.506 "iterations=8"
0.055 449.06 "iterations=7"
0.068 57.5822 "iterations=1"
0.11 35.6399 "passes=2 iterations=2"
0.116 17.418 "passes=2 iterations=2"
0.281 11.1437 "passes=3 substeps=2"
0.444 0.50034 "substeps=47"
0.676 0.333635 "substeps=71"
1.3 0.168506 "substeps=142"
END
$curve0 << END
0.024 633.963 "iterations=1"
0.03 597.393 "iterations=3"
0.042 607.065 "iterations=7"
0.065 584.116 "iterations=15"
0.112 536.605 "iterations=31"
0.208 467.102 "iterations=63"
0.396 383.293 "iterations=127"
0.831 292.772 "iterations=255"
END
$curve1 << END
0.027 628.384 "iterations=2"
0.045 468.506 "iterations=8"
0.068 474.033 "iterations=16"
0.209 496.523 "iterations=64"
END
$curve2 << END
0.037 560.217 "iterations=1"
0.055 449.06 "iterations=7"
0.124 374.257 "iterations=31"
0.408 265.629 "iterations=127"
END
$curve3 << END
0.077 511.548 "iterations=7 substeps=2"
0.152 343.918 "iterations=7 substeps=4"
0.296 202.576 "iterations=7 substeps=8"
0.583 70.1238 "iterations=7 substeps=16"
END
$curve4 << END
0.034 603.861 "iterations=4"
0.046 494.345 "iterations=8"
0.071 363.557 "iterations=16"
0.124 158.929 "iterations=32"
0.227 79.2013 "iterations=64"
0.44 76.7062 "iterations=128"
END
$curve5 << END
0.045 600.013 "iterations=4"
0.071 483.223 "iterations=8"
0.123 344.698 "iterations=16"
0.23 117.59 "iterations=32"
0.439 81.3823 "iterations=64"
0.885 79.534 "iterations=128"
END
$curve6 << END
0.068 57.5822 "iterations=1"
0.12 38.5668 "iterations=2"
0.162 39.6175 "iterations=4"
0.243 39.6306 "iterations=8"
END
$curve7 << END
0.091 62.6509 "passes=2 iterations=1"
0.11 35.6399 "passes=2 iterations=2"
0.12 35.5868 "passes=3 iterations=1"
0.145 39.453 "passes=3 iterations=2"
0.146 39.4045 "passes=2 iterations=4"
0.154 45.0043 "passes=4 iterations=1"
0.177 37.6757 "passes=4 iterations=2"
0.179 38.7781 "passes=3 iterations=4"
0.186 39.5898 "passes=2 iterations=6"
0.217 38.4894 "passes=4 iterations=4"
0.217 40.8654 "passes=6 iterations=1"
0.224 38.6614 "passes=3 iterations=6"
0.236 38.1504 "passes=6 iterations=2"
0.277 39.5083 "passes=8 iterations=1"
0.301 38.2854 "passes=8 iterations=2"
END
$curve8 << END
0.13 32.3992 "passes=1 substeps=2"
0.253 23.5656 "passes=1 substeps=4"
0.511 17.8664 "passes=1 substeps=8"
1.045 12.8764 "passes=1 substeps=16"
END
$curve9 << END
0.116 17.418 "passes=2 iterations=2"
0.123 25.2919 "passes=1 iterations=2"
0.15 21.9287 "passes=3 iterations=2"
0.179 19.9693 "passes=4 iterations=2"
0.217 20.7119 "passes=4 iterations=4"
0.28 20.5066 "passes=6 iterations=4"
END
$curve10 << END
0.281 11.1437 "passes=3 substeps=2"
0.576 4.51308 "passes=3 substeps=4"
1.201 1.32323 "passes=3 substeps=8"
END
$curve11 << END
0.051 830.622 "substeps=1"
0.096 654.729 "substeps=2"
0.187 371.402 "substeps=4"
0.37 131.982 "substeps=8"
0.735 56.1214 "substeps=16"
1.485 22.6708 "substeps=32"
2.997 8.48438 "substeps=64"
END
$curve12 << END
0.082 644.359 "iterations=4"
0.205 338.449 "iterations=16"
0.726 118.725 "iterations=64"
END
$curve13 << END
0.094 554.92 "iterations=4"
0.253 237.856 "iterations=16"
0.896 69.792 "iterations=64"
END
$curve14 << END
0.201 291.026 "iterations=1 substeps=4"
0.788 26.7179 "iterations=1 substeps=16"
3.208 5.06628 "iterations=1 substeps=64"
END
$curve15 << END
0.444 0.50034 "substeps=47"
0.676 0.333635 "substeps=71"
1.3 0.168506 "substeps=142"
END
$curve16 << END
1.958 5.80992 "substeps=142"
END
$curve17 << END
16.562 79.5353 "one factorisation a step"
END
$default << END
0.15 21.9287 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-32-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  38.4424 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.7229 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-32-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  38.4424 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.7229 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
