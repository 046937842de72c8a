set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0168:26.4992]
set yrange [1.46515:4690]
set title 'Sheet hung by two corners, 32 × 32 particles: distance from converged backward Euler after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=47; Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.024 1128.64 "iterations=1"
0.027 631.456 "iterations=2"
0.045 500.517 "iterations=8"
0.068 146.229 "iterations=1"
0.091 12.4197 "passes=2 iterations=1"
0.12 10.6751 "iterations=2"
0.145 2.09307 "passes=3 iterations=2"
END
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
0.077 535.721 "iterations=7 substeps=2"
0.152 155.316 "iterations=7 substeps=4"
0.296 82.0673 "iterations=7 substeps=8"
0.583 147.299 "iterations=7 substeps=16"
END
$curve4 << END
0.034 853.847 "iterations=4"
0.046 566.784 "iterations=8"
0.071 313.527 "iterations=16"
0.124 66.2568 "iterations=32"
0.227 75.8721 "iterations=64"
0.44 88.3914 "iterations=128"
END
$curve5 << END
0.045 900.015 "iterations=4"
0.071 572.704 "iterations=8"
0.123 310.004 "iterations=16"
0.23 84.8681 "iterations=32"
0.439 97.8882 "iterations=64"
0.885 92.0643 "iterations=128"
END
$curve6 << END
0.068 146.229 "iterations=1"
0.12 10.6751 "iterations=2"
0.162 11.6745 "iterations=4"
0.243 13.057 "iterations=8"
END
$curve7 << END
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
$curve8 << END
0.13 38.9612 "passes=1 substeps=2"
0.253 90.727 "passes=1 substeps=4"
0.511 112.471 "passes=1 substeps=8"
1.045 133.448 "passes=1 substeps=16"
END
$curve9 << END
0.116 171.308 "passes=2 iterations=2"
0.123 147.769 "passes=1 iterations=2"
0.15 172.584 "passes=3 iterations=2"
0.179 174.038 "passes=4 iterations=2"
0.217 176.787 "passes=4 iterations=4"
0.28 177.123 "passes=6 iterations=4"
END
$curve10 << END
0.281 174.887 "passes=3 substeps=2"
0.576 177.304 "passes=3 substeps=4"
1.201 179.876 "passes=3 substeps=8"
END
$curve11 << END
0.051 2931.25 "substeps=1"
0.096 1065.78 "substeps=2"
0.187 159.746 "substeps=4"
0.37 128.011 "substeps=8"
0.735 159.605 "substeps=16"
1.485 170.219 "substeps=32"
2.997 173.418 "substeps=64"
END
$curve12 << END
0.082 1026.86 "iterations=4"
0.205 155.705 "iterations=16"
0.726 28.6205 "iterations=64"
END
$curve13 << END
0.094 630.374 "iterations=4"
0.253 54.7229 "iterations=16"
0.896 43.8124 "iterations=64"
END
$curve14 << END
0.201 96.2126 "iterations=1 substeps=4"
0.788 168.734 "iterations=1 substeps=16"
3.208 171.814 "iterations=1 substeps=64"
END
$curve15 << END
0.444 180.267 "substeps=47"
0.676 180.534 "substeps=71"
1.3 180.342 "substeps=142"
END
$curve16 << END
1.958 189.491 "substeps=142"
END
$curve17 << END
16.562 92.0756 "one factorisation a step"
END
$default << END
0.15 172.584 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-32-a-1s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  92.0774 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
set output 'accuracy-hanging-32-a-1s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  92.0774 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
