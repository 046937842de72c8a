set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0154:21.6544]
set yrange [0.128174:788.627]
set title 'Hung sheet in wind, 32 × 32 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=47' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.022 92.6154 "iterations=1"
0.028 82.9237 "iterations=3"
0.031 62.1516 "iterations=1"
0.044 56.2734 "iterations=8"
0.047 46.6494 "iterations=7"
0.066 37.1815 "iterations=16"
0.069 16.033 "passes=1"
0.098 15.749 "passes=2"
0.129 9.29956 "passes=1 substeps=2"
0.265 5.66039 "passes=1 substeps=4"
0.529 0.547488 "substeps=47"
0.799 0.362559 "substeps=71"
1.587 0.183106 "substeps=142"
END
$curve0 << END
0.022 92.6154 "iterations=1"
0.028 82.9237 "iterations=3"
0.04 81.0211 "iterations=7"
0.061 74.6609 "iterations=15"
0.103 64.1913 "iterations=31"
0.188 52.3174 "iterations=63"
0.36 38.8311 "iterations=127"
0.699 27.1772 "iterations=255"
END
$curve1 << END
0.025 174.495 "iterations=2"
0.043 87.9308 "iterations=8"
0.064 138.605 "iterations=16"
0.191 167.208 "iterations=64"
END
$curve2 << END
0.031 62.1516 "iterations=1"
0.047 46.6494 "iterations=7"
0.112 37.6817 "iterations=31"
0.369 40.6523 "iterations=127"
END
$curve3 << END
0.072 63.2614 "iterations=7 substeps=2"
0.143 41.6238 "iterations=7 substeps=4"
0.269 17.6255 "iterations=7 substeps=8"
0.54 5.80859 "iterations=7 substeps=16"
END
$curve4 << END
0.031 82.9171 "iterations=4"
0.044 56.2734 "iterations=8"
0.066 37.1815 "iterations=16"
0.11 19.2303 "iterations=32"
0.199 18.9704 "iterations=64"
0.377 18.2918 "iterations=128"
END
$curve5 << END
0.042 82.6574 "iterations=4"
0.063 55.2534 "iterations=8"
0.106 32.6821 "iterations=16"
0.194 18.3709 "iterations=32"
0.371 18.3838 "iterations=64"
0.734 18.4089 "iterations=128"
END
$curve6 << END
0.069 16.033 "passes=1"
0.098 15.749 "passes=2"
0.132 16.0401 "passes=3"
0.171 16.0382 "passes=4"
0.227 15.959 "passes=6"
0.295 15.9316 "passes=8"
0.451 15.9202 "passes=12"
0.649 15.9178 "passes=18"
END
$curve7 << END
0.129 9.29956 "passes=1 substeps=2"
0.265 5.66039 "passes=1 substeps=4"
0.547 3.62036 "passes=1 substeps=8"
1.149 2.20916 "passes=1 substeps=16"
END
$curve8 << END
0.11 21.5935 "passes=1"
0.11 21.7679 "passes=2"
0.148 20.1192 "passes=3"
0.18 20.758 "passes=4"
0.247 20.6204 "passes=6"
0.32 20.5713 "passes=8"
0.465 20.5492 "passes=12"
END
$curve9 << END
0.215 14.6528 "passes=1 substeps=2"
0.273 12.5752 "passes=3 substeps=2"
0.424 8.60741 "passes=1 substeps=4"
0.545 7.21899 "passes=3 substeps=4"
0.823 4.74521 "passes=1 substeps=8"
1.086 3.95737 "passes=3 substeps=8"
END
$curve10 << END
0.049 492.892 "substeps=1"
0.093 453.138 "substeps=2"
0.181 241.733 "substeps=4"
0.355 67.5198 "substeps=8"
0.712 32.2237 "substeps=16"
1.413 11.901 "substeps=32"
2.83 3.58761 "substeps=64"
END
$curve11 << END
0.075 387.609 "iterations=4"
0.181 178.255 "iterations=16"
0.61 45.6365 "iterations=64"
END
$curve12 << END
0.053 469.671 "iterations=1"
0.089 313.201 "iterations=4"
0.235 109.61 "iterations=16"
0.827 40.1179 "iterations=64"
END
$curve13 << END
0.194 177.116 "iterations=1 substeps=4"
0.751 21.6995 "iterations=1 substeps=16"
3.067 2.61335 "iterations=1 substeps=64"
END
$curve14 << END
0.529 0.547488 "substeps=47"
0.799 0.362559 "substeps=71"
1.587 0.183106 "substeps=142"
END
$curve15 << END
2.122 4.6421 "substeps=142"
END
$curve16 << END
13.534 18.4091 "one factorisation a step"
END
$default << END
0.148 20.1192 "passes=3"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-32-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  15.9174 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.5471 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
set output 'accuracy-wind-32-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  15.9174 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.5471 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
