set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0168:26.4992]
set yrange [1.46515:1805.82]
set title 'Sheet hung by two corners, 32 × 32 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=47; Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.024 1128.64 "iterations=1"
0.03 1097.91 "iterations=3"
0.042 977.007 "iterations=7"
0.065 791.39 "iterations=15"
0.112 645.119 "iterations=31"
0.208 526.255 "iterations=63"
0.396 421.53 "iterations=127"
0.831 311.824 "iterations=255"
END
$curve1 << END
0.027 631.456 "iterations=2"
0.045 500.517 "iterations=8"
0.068 357.492 "iterations=16"
0.209 265.481 "iterations=64"
END
$curve2 << END
0.037 786.5 "iterations=1"
0.055 549.356 "iterations=7"
0.124 396.3 "iterations=31"
0.408 281.834 "iterations=127"
END
$curve3 << END
0.034 853.847 "iterations=4"
0.046 566.784 "iterations=8"
0.071 313.527 "iterations=16"
0.124 66.2568 "iterations=32"
0.227 75.8721 "iterations=64"
0.44 88.3914 "iterations=128"
END
$curve4 << END
0.045 900.015 "iterations=4"
0.071 572.704 "iterations=8"
0.123 310.004 "iterations=16"
0.23 84.8681 "iterations=32"
0.439 97.8882 "iterations=64"
0.885 92.0643 "iterations=128"
END
$curve5 << END
0.068 146.229 "iterations=1"
0.12 10.6751 "iterations=2"
0.162 11.6745 "iterations=4"
0.243 13.057 "iterations=8"
END
$curve6 << END
0.091 12.4197 "passes=2 iterations=1"
0.11 12.68 "passes=2 iterations=2"
0.12 11.4619 "passes=3 iterations=1"
0.145 2.09307 "passes=3 iterations=2"
0.146 11.5275 "passes=2 iterations=4"
0.154 4.5227 "passes=4 iterations=1"
0.177 2.32703 "passes=4 iterations=2"
0.179 5.10044 "passes=3 iterations=4"
0.186 13.5321 "passes=2 iterations=6"
0.217 4.19543 "passes=4 iterations=4"
0.217 3.62399 "passes=6 iterations=1"
0.224 5.20479 "passes=3 iterations=6"
0.236 2.20262 "passes=6 iterations=2"
0.277 3.03411 "passes=8 iterations=1"
0.301 2.19027 "passes=8 iterations=2"
END
$curve7 << END
0.116 42.3145 "passes=2 iterations=2"
0.123 69.6256 "passes=1 iterations=2"
0.15 20.2012 "passes=3 iterations=2"
0.179 8.5983 "passes=4 iterations=2"
0.217 8.17666 "passes=4 iterations=4"
0.28 6.18318 "passes=6 iterations=4"
END
$curve8 << END
0.324 183.148 "passes=2 iterations=2"
0.355 176.662 "passes=1 iterations=2"
0.42 176.779 "passes=3 iterations=2"
0.521 174.305 "passes=4 iterations=2"
0.719 172.738 "passes=6 iterations=2"
END
$curve9 << END
16.562 92.0756 "one factorisation a step"
END
$default << END
0.15 20.2012 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-32-own-1s.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-32-own-1s.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
