set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0196:26.0768]
set yrange [0.307343:959.597]
set title 'Hung sheet in wind, 32 × 32 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=47' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.028 182.355 "iterations=1"
0.035 128.639 "iterations=3"
0.046 74.6381 "iterations=7"
0.07 36.8941 "iterations=15"
0.119 32.4187 "iterations=31"
0.215 20.3108 "iterations=63"
0.408 15.0163 "iterations=127"
0.79 15.3668 "iterations=255"
END
$curve1 << END
0.032 560.92 "iterations=2"
0.049 552.428 "iterations=8"
0.073 599.748 "iterations=16"
0.218 338.275 "iterations=64"
END
$curve2 << END
0.038 137.662 "iterations=1"
0.057 95.6248 "iterations=7"
0.126 38.351 "iterations=31"
0.412 45.3667 "iterations=127"
END
$curve3 << END
0.038 49.1697 "iterations=4"
0.051 34.746 "iterations=8"
0.076 16.2977 "iterations=16"
0.125 12.1892 "iterations=32"
0.229 10.4123 "iterations=64"
0.43 10.8917 "iterations=128"
END
$curve4 << END
0.048 51.6487 "iterations=4"
0.073 29.024 "iterations=8"
0.126 16.2373 "iterations=16"
0.226 11.2155 "iterations=32"
0.44 10.978 "iterations=64"
0.856 11.041 "iterations=128"
END
$curve5 << END
0.065 13.6407 "iterations=1"
0.083 6.08927 "iterations=2"
0.12 5.8696 "iterations=4"
0.195 5.76664 "iterations=8"
END
$curve6 << END
0.096 4.85703 "passes=2 iterations=1"
0.114 1.89983 "passes=2 iterations=2"
0.126 2.30621 "passes=3 iterations=1"
0.146 1.78374 "passes=3 iterations=2"
0.152 2.16626 "passes=2 iterations=4"
0.157 1.83916 "passes=4 iterations=1"
0.177 0.895687 "passes=4 iterations=2"
0.182 1.84241 "passes=3 iterations=4"
0.189 2.30959 "passes=2 iterations=6"
0.216 1.1973 "passes=4 iterations=4"
0.22 1.77083 "passes=3 iterations=6"
0.22 1.13941 "passes=6 iterations=1"
0.238 0.618264 "passes=6 iterations=2"
0.286 0.656765 "passes=8 iterations=1"
0.311 0.439062 "passes=8 iterations=2"
END
$curve7 << END
0.122 5.78644 "passes=2 iterations=2"
0.129 6.47885 "passes=1 iterations=2"
0.154 4.72864 "passes=3 iterations=2"
0.187 2.38616 "passes=4 iterations=2"
0.219 1.9759 "passes=4 iterations=4"
0.282 1.58946 "passes=6 iterations=4"
END
$curve8 << END
0.23 16.6834 "passes=1 iterations=2"
0.327 10.558 "passes=2 iterations=2"
0.431 8.93811 "passes=3 iterations=2"
0.53 8.1974 "passes=4 iterations=2"
0.724 7.86525 "passes=6 iterations=2"
END
$curve9 << END
16.298 11.0401 "one factorisation a step"
END
$default << END
0.154 4.72864 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-32-own-1s.svg'
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
set output 'accuracy-wind-32-own-1s.png'
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
