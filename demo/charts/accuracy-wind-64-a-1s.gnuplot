set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.07:271.626]
set yrange [1.20674:2910.77]
set title 'Hung sheet in wind, 64 × 64 particles: distance from converged backward Euler after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=126; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.1 92.9578 "iterations=1"
0.148 49.6909 "iterations=1"
0.232 32.5892 "iterations=1"
0.287 29.215 "iterations=16"
0.32 19.0747 "iterations=2"
0.354 10.8268 "passes=2 iterations=1"
0.443 4.87256 "passes=2 iterations=2"
0.573 2.37674 "passes=3 iterations=2"
0.681 1.92436 "passes=4 iterations=2"
1.252 1.72392 "passes=8 iterations=2"
END
$curve0 << END
0.1 92.9578 "iterations=1"
0.125 106.253 "iterations=3"
0.172 137.309 "iterations=7"
0.265 145.353 "iterations=15"
0.454 87.0062 "iterations=31"
0.836 44.3475 "iterations=63"
1.608 32.4788 "iterations=127"
3.16 22.5354 "iterations=255"
END
$curve1 << END
0.182 279.734 "iterations=8"
0.277 348.025 "iterations=16"
0.845 235.791 "iterations=64"
END
$curve2 << END
0.148 49.6909 "iterations=1"
0.21 121.992 "iterations=7"
0.49 86.302 "iterations=31"
1.652 42.7169 "iterations=127"
END
$curve3 << END
0.33 102.406 "iterations=7 substeps=2"
0.647 39.3828 "iterations=7 substeps=4"
1.294 24.3154 "iterations=7 substeps=8"
2.608 9.64492 "iterations=7 substeps=16"
END
$curve4 << END
0.139 153.138 "iterations=4"
0.188 74.9731 "iterations=8"
0.287 29.215 "iterations=16"
0.49 17.3766 "iterations=32"
0.91 12.4147 "iterations=64"
1.746 13.6725 "iterations=128"
END
$curve5 << END
0.181 150.436 "iterations=4"
0.284 64.9524 "iterations=8"
0.491 28.3835 "iterations=16"
0.916 17.1851 "iterations=32"
1.751 13.3692 "iterations=64"
3.441 13.2569 "iterations=128"
END
$curve6 << END
0.232 32.5892 "iterations=1"
0.32 19.0747 "iterations=2"
0.487 7.58872 "iterations=4"
0.804 8.00822 "iterations=8"
END
$curve7 << END
0.354 10.8268 "passes=2 iterations=1"
0.443 4.87256 "passes=2 iterations=2"
0.497 4.87677 "passes=3 iterations=1"
0.573 2.37674 "passes=3 iterations=2"
0.603 3.00761 "passes=4 iterations=1"
0.606 4.77514 "passes=2 iterations=4"
0.681 1.92436 "passes=4 iterations=2"
0.725 2.16254 "passes=3 iterations=4"
0.781 5.34615 "passes=2 iterations=6"
0.876 1.96645 "passes=4 iterations=4"
0.891 2.53546 "passes=6 iterations=1"
0.909 2.24295 "passes=3 iterations=6"
0.984 2.01686 "passes=6 iterations=2"
1.148 2.20196 "passes=8 iterations=1"
1.252 1.72392 "passes=8 iterations=2"
END
$curve8 << END
0.454 25.3296 "passes=1 substeps=2"
0.908 9.83654 "passes=1 substeps=4"
1.838 13.3677 "passes=1 substeps=8"
3.794 14.744 "passes=1 substeps=16"
END
$curve9 << END
0.453 26.9673 "passes=2 iterations=2"
0.483 27.0076 "passes=1 iterations=2"
0.582 26.0593 "passes=3 iterations=2"
0.718 12.8104 "passes=4 iterations=2"
0.878 21.3023 "passes=4 iterations=4"
1.166 8.97005 "passes=6 iterations=4"
END
$curve10 << END
1.167 11.0672 "passes=3 substeps=2"
2.377 31.2454 "passes=3 substeps=4"
4.998 36.5057 "passes=3 substeps=8"
END
$curve11 << END
0.216 1819.23 "substeps=1"
0.42 1612.1 "substeps=2"
0.828 829.334 "substeps=4"
1.667 237.484 "substeps=8"
3.376 83.9931 "substeps=16"
6.708 43.7946 "substeps=32"
13.442 39.0806 "substeps=64"
END
$curve12 << END
0.348 1475.46 "iterations=4"
0.887 680.077 "iterations=16"
3.025 175.595 "iterations=64"
END
$curve13 << END
0.36 1232.37 "iterations=4"
0.933 463.701 "iterations=16"
3.243 167.217 "iterations=64"
END
$curve14 << END
3.468 81.9237 "iterations=1 substeps=16"
13.723 42.922 "iterations=1 substeps=64"
END
$curve15 << END
6.543 38.1083 "substeps=126"
10.039 38.1138 "substeps=193"
19.936 38.1438 "substeps=386"
END
$curve16 << END
24.595 38.1969 "substeps=386"
END
$curve17 << END
169.766 13.3155 "one factorisation a step"
END
$default << END
0.582 26.0593 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-64-a-1s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  13.3156 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
set output 'accuracy-wind-64-a-1s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  13.3156 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
