set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0196:26.0768]
set yrange [0.128174:788.627]
set title 'Hung sheet in wind, 32 × 32 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=47' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.028 92.6154 "iterations=1"
0.035 82.9237 "iterations=3"
0.038 62.1516 "iterations=1"
0.051 56.2734 "iterations=8"
0.057 46.6494 "iterations=7"
0.065 18.579 "iterations=1"
0.083 15.9121 "iterations=2"
0.114 15.7271 "passes=2 iterations=2"
0.123 10.8296 "passes=1 substeps=2"
0.245 6.7958 "passes=1 substeps=4"
0.484 4.42291 "passes=1 substeps=8"
0.615 0.547488 "substeps=47"
0.924 0.362559 "substeps=71"
1.88 0.183106 "substeps=142"
END
$curve0 << END
0.028 92.6154 "iterations=1"
0.035 82.9237 "iterations=3"
0.046 81.0211 "iterations=7"
0.07 74.6609 "iterations=15"
0.119 64.1913 "iterations=31"
0.215 52.3174 "iterations=63"
0.408 38.8311 "iterations=127"
0.79 27.1772 "iterations=255"
END
$curve1 << END
0.032 174.495 "iterations=2"
0.049 87.9308 "iterations=8"
0.073 138.605 "iterations=16"
0.218 167.208 "iterations=64"
END
$curve2 << END
0.038 62.1516 "iterations=1"
0.057 46.6494 "iterations=7"
0.126 37.6817 "iterations=31"
0.412 40.6523 "iterations=127"
END
$curve3 << END
0.087 63.2614 "iterations=7 substeps=2"
0.167 41.6238 "iterations=7 substeps=4"
0.327 17.6255 "iterations=7 substeps=8"
0.66 5.80859 "iterations=7 substeps=16"
END
$curve4 << END
0.038 82.9171 "iterations=4"
0.051 56.2734 "iterations=8"
0.076 37.1815 "iterations=16"
0.125 19.2303 "iterations=32"
0.229 18.9704 "iterations=64"
0.43 18.2918 "iterations=128"
END
$curve5 << END
0.048 82.688 "iterations=4"
0.073 55.2573 "iterations=8"
0.126 32.6776 "iterations=16"
0.226 18.371 "iterations=32"
0.44 18.384 "iterations=64"
0.856 18.4089 "iterations=128"
END
$curve6 << END
0.065 18.579 "iterations=1"
0.083 15.9121 "iterations=2"
0.12 16.4543 "iterations=4"
0.195 16.4479 "iterations=8"
END
$curve7 << END
0.096 16.5617 "passes=2 iterations=1"
0.114 15.7271 "passes=2 iterations=2"
0.126 15.9172 "passes=3 iterations=1"
0.146 16.0721 "passes=3 iterations=2"
0.152 16.0097 "passes=2 iterations=4"
0.157 16.2117 "passes=4 iterations=1"
0.177 15.9089 "passes=4 iterations=2"
0.182 16.0038 "passes=3 iterations=4"
0.189 16.0379 "passes=2 iterations=6"
0.216 15.9693 "passes=4 iterations=4"
0.22 15.9647 "passes=3 iterations=6"
0.22 16.0725 "passes=6 iterations=1"
0.238 15.9404 "passes=6 iterations=2"
0.286 16.0068 "passes=8 iterations=1"
0.311 15.9387 "passes=8 iterations=2"
END
$curve8 << END
0.123 10.8296 "passes=1 substeps=2"
0.245 6.7958 "passes=1 substeps=4"
0.484 4.42291 "passes=1 substeps=8"
0.969 2.83724 "passes=1 substeps=16"
END
$curve9 << END
0.122 19.738 "passes=2 iterations=2"
0.129 21.4908 "passes=1 iterations=2"
0.154 20.8222 "passes=3 iterations=2"
0.187 20.4955 "passes=4 iterations=2"
0.219 20.6036 "passes=4 iterations=4"
0.282 20.5687 "passes=6 iterations=4"
END
$curve10 << END
0.291 13.3249 "passes=3 substeps=2"
0.581 7.69504 "passes=3 substeps=4"
1.17 4.17503 "passes=3 substeps=8"
END
$curve11 << END
0.055 492.892 "substeps=1"
0.104 453.138 "substeps=2"
0.204 241.733 "substeps=4"
0.402 67.5198 "substeps=8"
0.804 32.2237 "substeps=16"
1.618 11.901 "substeps=32"
3.227 3.58761 "substeps=64"
END
$curve12 << END
0.092 387.609 "iterations=4"
0.244 178.255 "iterations=16"
0.853 45.6365 "iterations=64"
END
$curve13 << END
0.058 469.671 "iterations=1"
0.098 313.201 "iterations=4"
0.257 109.61 "iterations=16"
0.899 40.1179 "iterations=64"
END
$curve14 << END
0.216 177.116 "iterations=1 substeps=4"
0.848 21.6995 "iterations=1 substeps=16"
3.463 2.61335 "iterations=1 substeps=64"
END
$curve15 << END
0.615 0.547488 "substeps=47"
0.924 0.362559 "substeps=71"
1.88 0.183106 "substeps=142"
END
$curve16 << END
2.549 4.6421 "substeps=142"
END
$curve17 << END
16.298 18.4091 "one factorisation a step"
END
$default << END
0.154 20.8222 "passes=3 iterations=2"
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
