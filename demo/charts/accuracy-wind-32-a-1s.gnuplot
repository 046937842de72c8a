set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0154:21.6544]
set yrange [0.0125317:2222.58]
set title 'Hung sheet in wind, 32 × 32 particles: distance from converged backward Euler after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=47' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.022 182.355 "iterations=1"
0.028 128.639 "iterations=3"
0.031 49.1697 "iterations=4"
0.044 34.746 "iterations=8"
0.063 29.0123 "iterations=8"
0.066 16.2977 "iterations=16"
0.069 10.7844 "passes=1"
0.098 3.72651 "passes=2"
0.132 1.7676 "passes=3"
0.171 1.2948 "passes=4"
0.227 0.536862 "passes=6"
0.295 0.328482 "passes=8"
0.451 0.0771673 "passes=12"
0.649 0.0179024 "passes=18"
END
$curve0 << END
0.022 182.355 "iterations=1"
0.028 128.639 "iterations=3"
0.04 74.6381 "iterations=7"
0.061 36.8941 "iterations=15"
0.103 32.4187 "iterations=31"
0.188 20.3108 "iterations=63"
0.36 15.0163 "iterations=127"
0.699 15.3669 "iterations=255"
END
$curve1 << END
0.025 560.92 "iterations=2"
0.043 552.428 "iterations=8"
0.064 599.748 "iterations=16"
0.191 338.275 "iterations=64"
END
$curve2 << END
0.031 137.662 "iterations=1"
0.047 95.6248 "iterations=7"
0.112 38.351 "iterations=31"
0.369 45.3667 "iterations=127"
END
$curve3 << END
0.072 38.419 "iterations=7 substeps=2"
0.143 18.7207 "iterations=7 substeps=4"
0.269 8.22481 "iterations=7 substeps=8"
0.54 10.8266 "iterations=7 substeps=16"
END
$curve4 << END
0.031 49.1697 "iterations=4"
0.044 34.746 "iterations=8"
0.066 16.2977 "iterations=16"
0.11 12.1892 "iterations=32"
0.199 10.4123 "iterations=64"
0.377 10.8917 "iterations=128"
END
$curve5 << END
0.042 51.6583 "iterations=4"
0.063 29.0123 "iterations=8"
0.106 16.2562 "iterations=16"
0.194 11.2159 "iterations=32"
0.371 10.9776 "iterations=64"
0.734 11.0409 "iterations=128"
END
$curve6 << END
0.069 10.7844 "passes=1"
0.098 3.72651 "passes=2"
0.132 1.7676 "passes=3"
0.171 1.2948 "passes=4"
0.227 0.536862 "passes=6"
0.295 0.328482 "passes=8"
0.451 0.0771673 "passes=12"
0.649 0.0179024 "passes=18"
END
$curve7 << END
0.129 7.21545 "passes=1 substeps=2"
0.265 10.5119 "passes=1 substeps=4"
0.547 12.0558 "passes=1 substeps=8"
1.149 15.4605 "passes=1 substeps=16"
END
$curve8 << END
0.11 14.6121 "passes=1"
0.11 14.6684 "passes=2"
0.148 20.563 "passes=3"
0.18 23.1492 "passes=4"
0.247 23.8561 "passes=6"
0.32 23.4322 "passes=8"
0.465 23.564 "passes=12"
END
$curve9 << END
0.215 13.2302 "passes=1 substeps=2"
0.273 27.0939 "passes=3 substeps=2"
0.424 30.3632 "passes=1 substeps=4"
0.545 31.6955 "passes=3 substeps=4"
0.823 32.2957 "passes=1 substeps=8"
1.086 33.0045 "passes=3 substeps=8"
END
$curve10 << END
0.049 1389.11 "substeps=1"
0.093 624.788 "substeps=2"
0.181 186.614 "substeps=4"
0.355 81.959 "substeps=8"
0.712 21.9924 "substeps=16"
1.413 34.7676 "substeps=32"
2.83 35.0504 "substeps=64"
END
$curve11 << END
0.075 553.153 "iterations=4"
0.181 146.388 "iterations=16"
0.61 58.139 "iterations=64"
END
$curve12 << END
0.053 1221.87 "iterations=1"
0.089 395.983 "iterations=4"
0.235 135.495 "iterations=16"
0.827 41.5073 "iterations=64"
END
$curve13 << END
0.194 187.215 "iterations=1 substeps=4"
0.751 42.2041 "iterations=1 substeps=16"
3.067 35.001 "iterations=1 substeps=64"
END
$curve14 << END
0.529 33.9984 "substeps=47"
0.799 34.0241 "substeps=71"
1.587 34.0637 "substeps=142"
END
$curve15 << END
2.122 33.4676 "substeps=142"
END
$curve16 << END
13.534 11.0401 "one factorisation a step"
END
$default << END
0.148 20.563 "passes=3"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-32-a-1s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  11.0403 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-32-a-1s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  11.0403 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
