set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0196:26.0768]
set yrange [1.00925:4174.78]
set title 'Hung sheet in wind, 32 × 32 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=47' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.028 135.418 "iterations=1"
0.035 99.6918 "iterations=3"
0.046 61.5108 "iterations=7"
0.07 28.6163 "iterations=15"
0.119 10.4947 "iterations=31"
0.215 10.3163 "iterations=63"
0.408 19.0669 "iterations=127"
0.79 13.5327 "iterations=255"
END
$curve1 << END
0.032 409.305 "iterations=2"
0.049 241.031 "iterations=8"
0.073 230.003 "iterations=16"
0.218 117.383 "iterations=64"
END
$curve2 << END
0.038 14.9142 "iterations=1"
0.057 3.03202 "iterations=7"
0.126 1.44179 "iterations=31"
0.412 1.71504 "iterations=127"
END
$curve3 << END
0.087 11.5336 "iterations=7 substeps=2"
0.167 21.8303 "iterations=7 substeps=4"
0.327 20.6063 "iterations=7 substeps=8"
0.66 16.744 "iterations=7 substeps=16"
END
$curve4 << END
0.038 43.8313 "iterations=4"
0.051 10.328 "iterations=8"
0.076 18.6422 "iterations=16"
0.125 16.0574 "iterations=32"
0.229 15.6308 "iterations=64"
0.43 15.6349 "iterations=128"
END
$curve5 << END
0.048 44.8439 "iterations=4"
0.073 10.5673 "iterations=8"
0.126 17.0895 "iterations=16"
0.226 15.887 "iterations=32"
0.44 15.6244 "iterations=64"
0.856 15.6281 "iterations=128"
END
$curve6 << END
0.065 15.4879 "iterations=1"
0.083 15.6467 "iterations=2"
0.12 15.756 "iterations=4"
0.195 15.6765 "iterations=8"
END
$curve7 << END
0.096 15.8565 "passes=2 iterations=1"
0.114 16.032 "passes=2 iterations=2"
0.126 15.9739 "passes=3 iterations=1"
0.146 15.9611 "passes=3 iterations=2"
0.152 16.0151 "passes=2 iterations=4"
0.157 15.9595 "passes=4 iterations=1"
0.177 15.9767 "passes=4 iterations=2"
0.182 15.9813 "passes=3 iterations=4"
0.189 16.0384 "passes=2 iterations=6"
0.216 15.9785 "passes=4 iterations=4"
0.22 15.9788 "passes=3 iterations=6"
0.22 15.9436 "passes=6 iterations=1"
0.238 15.9698 "passes=6 iterations=2"
0.286 15.9506 "passes=8 iterations=1"
0.311 15.9631 "passes=8 iterations=2"
END
$curve8 << END
0.123 16.2447 "passes=1 substeps=2"
0.245 16.061 "passes=1 substeps=4"
0.484 16.0497 "passes=1 substeps=8"
0.969 16.4125 "passes=1 substeps=16"
END
$curve9 << END
0.122 16.134 "passes=2 iterations=2"
0.129 16.2154 "passes=1 iterations=2"
0.154 15.9482 "passes=3 iterations=2"
0.187 16.1771 "passes=4 iterations=2"
0.219 16.2229 "passes=4 iterations=4"
0.282 16.2258 "passes=6 iterations=4"
END
$curve10 << END
0.291 17.3694 "passes=3 substeps=2"
0.581 16.7225 "passes=3 substeps=4"
1.17 16.1044 "passes=3 substeps=8"
END
$curve11 << END
0.23 16.1807 "passes=1 iterations=2"
0.327 16.5103 "passes=2 iterations=2"
0.431 16.6218 "passes=3 iterations=2"
0.53 16.6203 "passes=4 iterations=2"
0.724 16.6332 "passes=6 iterations=2"
END
$curve12 << END
0.055 2068.64 "substeps=1"
0.104 902.912 "substeps=2"
0.204 234.245 "substeps=4"
0.402 98.3022 "substeps=8"
0.804 38.2389 "substeps=16"
1.618 26.8535 "substeps=32"
3.227 19.5882 "substeps=64"
END
$curve13 << END
0.092 796.877 "iterations=4"
0.244 180.181 "iterations=16"
0.853 59.5096 "iterations=64"
END
$curve14 << END
0.058 2609.24 "iterations=1"
0.098 736.132 "iterations=4"
0.257 142.708 "iterations=16"
0.899 38.2774 "iterations=64"
END
$curve15 << END
0.216 260.086 "iterations=1 substeps=4"
0.848 31.897 "iterations=1 substeps=16"
3.463 17.706 "iterations=1 substeps=64"
END
$curve16 << END
0.615 16.3337 "substeps=47"
0.924 16.3119 "substeps=71"
1.88 16.2511 "substeps=142"
END
$curve17 << END
2.549 21.674 "substeps=142"
END
$curve18 << END
16.298 15.628 "one factorisation a step"
END
$default << END
0.154 15.9482 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-32-stretch.svg'
plot 16.262 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
set output 'accuracy-wind-32-stretch.png'
plot 16.262 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
