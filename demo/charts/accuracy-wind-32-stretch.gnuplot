set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0154:21.6544]
set yrange [1.00925:4174.78]
set title 'Hung sheet in wind, 32 × 32 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=47' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.022 135.418 "iterations=1"
0.028 99.6918 "iterations=3"
0.04 61.5108 "iterations=7"
0.061 28.6163 "iterations=15"
0.103 10.4947 "iterations=31"
0.188 10.3163 "iterations=63"
0.36 19.0669 "iterations=127"
0.699 13.5327 "iterations=255"
END
$curve1 << END
0.025 409.305 "iterations=2"
0.043 241.031 "iterations=8"
0.064 230.003 "iterations=16"
0.191 117.383 "iterations=64"
END
$curve2 << END
0.031 14.9142 "iterations=1"
0.047 3.03202 "iterations=7"
0.112 1.44179 "iterations=31"
0.369 1.71504 "iterations=127"
END
$curve3 << END
0.072 11.5336 "iterations=7 substeps=2"
0.143 21.8303 "iterations=7 substeps=4"
0.269 20.6063 "iterations=7 substeps=8"
0.54 16.744 "iterations=7 substeps=16"
END
$curve4 << END
0.031 43.8313 "iterations=4"
0.044 10.328 "iterations=8"
0.066 18.6422 "iterations=16"
0.11 16.0574 "iterations=32"
0.199 15.6308 "iterations=64"
0.377 15.6349 "iterations=128"
END
$curve5 << END
0.042 44.8999 "iterations=4"
0.063 10.5671 "iterations=8"
0.106 17.0874 "iterations=16"
0.194 15.887 "iterations=32"
0.371 15.6244 "iterations=64"
0.734 15.6281 "iterations=128"
END
$curve6 << END
0.069 15.1636 "passes=1"
0.098 15.8567 "passes=2"
0.132 15.9574 "passes=3"
0.171 15.9719 "passes=4"
0.227 15.9668 "passes=6"
0.295 15.9543 "passes=8"
0.451 15.9463 "passes=12"
0.649 15.9429 "passes=18"
END
$curve7 << END
0.129 16.055 "passes=1 substeps=2"
0.265 16.1018 "passes=1 substeps=4"
0.547 15.9924 "passes=1 substeps=8"
1.149 16.2682 "passes=1 substeps=16"
END
$curve8 << END
0.11 14.8913 "passes=1"
0.11 14.8534 "passes=2"
0.148 16.0106 "passes=3"
0.18 15.7852 "passes=4"
0.247 16.3002 "passes=6"
0.32 16.2073 "passes=8"
0.465 16.2067 "passes=12"
END
$curve9 << END
0.215 16.3069 "passes=1 substeps=2"
0.273 16.6274 "passes=3 substeps=2"
0.424 17.1398 "passes=1 substeps=4"
0.545 16.5846 "passes=3 substeps=4"
0.823 16.1315 "passes=1 substeps=8"
1.086 16.1296 "passes=3 substeps=8"
END
$curve10 << END
0.204 17.2957 "passes=1"
0.316 16.1239 "passes=2"
0.422 16.4656 "passes=3"
0.537 16.6 "passes=4"
0.755 16.6549 "passes=6"
END
$curve11 << END
0.049 2068.64 "substeps=1"
0.093 902.912 "substeps=2"
0.181 234.245 "substeps=4"
0.355 98.3022 "substeps=8"
0.712 38.2389 "substeps=16"
1.413 26.8535 "substeps=32"
2.83 19.5882 "substeps=64"
END
$curve12 << END
0.075 796.877 "iterations=4"
0.181 180.181 "iterations=16"
0.61 59.5096 "iterations=64"
END
$curve13 << END
0.053 2609.24 "iterations=1"
0.089 736.132 "iterations=4"
0.235 142.708 "iterations=16"
0.827 38.2774 "iterations=64"
END
$curve14 << END
0.194 260.086 "iterations=1 substeps=4"
0.751 31.897 "iterations=1 substeps=16"
3.067 17.706 "iterations=1 substeps=64"
END
$curve15 << END
0.529 16.3337 "substeps=47"
0.799 16.3119 "substeps=71"
1.587 16.2511 "substeps=142"
END
$curve16 << END
2.122 21.674 "substeps=142"
END
$curve17 << END
13.534 15.628 "one factorisation a step"
END
$default << END
0.148 16.0106 "passes=3"
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
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
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
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
