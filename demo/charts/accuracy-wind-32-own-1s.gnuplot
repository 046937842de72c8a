set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0154:21.6544]
set yrange [0.0125317:959.597]
set title 'Hung sheet in wind, 32 × 32 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=47' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
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
0.031 49.1697 "iterations=4"
0.044 34.746 "iterations=8"
0.066 16.2977 "iterations=16"
0.11 12.1892 "iterations=32"
0.199 10.4123 "iterations=64"
0.377 10.8917 "iterations=128"
END
$curve4 << END
0.042 51.6583 "iterations=4"
0.063 29.0123 "iterations=8"
0.106 16.2562 "iterations=16"
0.194 11.2159 "iterations=32"
0.371 10.9776 "iterations=64"
0.734 11.0409 "iterations=128"
END
$curve5 << END
0.069 10.7844 "passes=1"
0.098 3.72651 "passes=2"
0.132 1.7676 "passes=3"
0.171 1.2948 "passes=4"
0.227 0.536862 "passes=6"
0.295 0.328482 "passes=8"
0.451 0.0771673 "passes=12"
0.649 0.0179024 "passes=18"
END
$curve6 << END
0.11 18.4476 "passes=1"
0.11 18.8429 "passes=2"
0.148 6.71169 "passes=3"
0.18 5.66508 "passes=4"
0.247 1.58954 "passes=6"
0.32 0.941788 "passes=8"
0.465 0.589117 "passes=12"
END
$curve7 << END
0.204 34.4186 "passes=1"
0.316 12.7767 "passes=2"
0.422 9.29337 "passes=3"
0.537 8.92538 "passes=4"
0.755 7.44702 "passes=6"
END
$curve8 << END
13.534 11.0401 "one factorisation a step"
END
$default << END
0.148 6.71169 "passes=3"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-32-own-1s.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-32-own-1s.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
