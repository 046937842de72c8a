set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0926023:421.325]
set yrange [0.000801528:7.52734]
set title 'Dress hung by its neck, 4589 particles: energy left above the converged step' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'energy gap over that of the inertial start'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 5
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 8572a2e; κ = 1504; weft_study accuracy, then weft_study plot' at screen 0.012, screen 0.022 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.132289 4.70459 "substeps=1"
0.141893 0.557619 "iterations=1"
0.196896 0.494883 "iterations=3"
0.233799 0.402293 "iterations=4"
0.289249 0.031685 "iterations=1"
0.404086 0.0142608 "iterations=2"
0.468543 0.00882376 "passes=2 iterations=1"
0.586362 0.00556073 "passes=2 iterations=2"
0.673047 0.00506006 "passes=3 iterations=1"
0.753214 0.00340734 "passes=3 iterations=2"
0.929617 0.00264358 "passes=4 iterations=2"
1.12813 0.00158471 "passes=4 iterations=4"
1.23127 0.00154818 "passes=3 iterations=6"
1.59499 0.00114504 "passes=8 iterations=2"
END
$curve0 << END
0.141893 0.557619 "iterations=1"
0.196896 0.494883 "iterations=3"
0.28152 0.417679 "iterations=7"
0.500183 0.344542 "iterations=15"
0.940942 0.277093 "iterations=31"
1.72538 0.216419 "iterations=63"
3.43085 0.167691 "iterations=127"
6.39036 0.136375 "iterations=255"
END
$curve1 << END
0.161659 0.888803 "iterations=2"
0.318181 0.525346 "iterations=8"
0.475929 0.381859 "iterations=16"
1.75185 0.215578 "iterations=64"
END
$curve2 << END
0.149006 0.825789 "iterations=1"
0.308884 0.685773 "iterations=7"
0.839488 0.544992 "iterations=31"
3.34705 0.435818 "iterations=127"
END
$curve3 << END
0.517098 0.074351 "iterations=7 substeps=2"
1.09758 0.0150054 "iterations=7 substeps=4"
2.21648 0.00600685 "iterations=7 substeps=8"
4.32204 0.00298505 "iterations=7 substeps=16"
END
$curve4 << END
0.233799 0.402293 "iterations=4"
0.331154 0.311938 "iterations=8"
0.523045 0.180235 "iterations=16"
0.937693 0.124465 "iterations=32"
1.72742 0.103574 "iterations=64"
3.4434 0.0927194 "iterations=128"
END
$curve5 << END
0.295388 0.489933 "iterations=4"
0.472611 0.269829 "iterations=8"
0.840285 0.153835 "iterations=16"
1.40242 0.116043 "iterations=32"
2.72744 0.0918856 "iterations=64"
5.33405 0.0877702 "iterations=128"
END
$curve6 << END
0.393447 0.0316851 "iterations=1"
0.584592 0.0187789 "iterations=2"
0.924006 0.016446 "iterations=3"
1.17069 0.0139468 "iterations=4"
1.67323 0.0079268 "iterations=6"
2.10628 0.00678618 "iterations=8"
2.63534 0.00573888 "iterations=12"
3.4395 0.00381225 "iterations=16"
END
$curve7 << END
0.289249 0.031685 "iterations=1"
0.404086 0.0142608 "iterations=2"
0.619482 0.0100061 "iterations=4"
1.09147 0.00879837 "iterations=8"
END
$curve8 << END
0.468543 0.00882376 "passes=2 iterations=1"
0.586362 0.00556073 "passes=2 iterations=2"
0.673047 0.00506006 "passes=3 iterations=1"
0.753214 0.00340734 "passes=3 iterations=2"
0.82644 0.0035189 "passes=2 iterations=4"
0.898871 0.00386755 "passes=4 iterations=1"
0.929617 0.00264358 "passes=4 iterations=2"
1.06301 0.0027373 "passes=2 iterations=6"
1.12813 0.00158471 "passes=4 iterations=4"
1.20038 0.00208987 "passes=3 iterations=4"
1.23127 0.00154818 "passes=3 iterations=6"
1.34811 0.00266856 "passes=6 iterations=1"
1.48793 0.00161678 "passes=6 iterations=2"
1.59499 0.00114504 "passes=8 iterations=2"
1.70153 0.002041 "passes=8 iterations=1"
END
$curve9 << END
0.653642 0.0114114 "passes=1 substeps=2"
1.25719 0.00461204 "passes=1 substeps=4"
2.36402 0.00230815 "passes=1 substeps=8"
4.54829 0.00166204 "passes=1 substeps=16"
END
$curve10 << END
0.132289 4.70459 "substeps=1"
0.249947 4.46804 "substeps=2"
0.479451 3.88605 "substeps=4"
0.984399 2.59503 "substeps=8"
1.89276 1.15672 "substeps=16"
3.76356 0.351562 "substeps=32"
7.58765 0.0861218 "substeps=64"
END
$curve11 << END
0.413114 3.98844 "iterations=4"
1.43704 3.41835 "iterations=16"
5.54176 2.15516 "iterations=64"
END
$curve12 << END
0.223833 3.96445 "iterations=1"
0.724123 3.0005 "iterations=4"
2.6884 2.43031 "iterations=16"
10.6584 1.30885 "iterations=64"
END
$curve13 << END
0.868868 2.53926 "iterations=1 substeps=4"
3.46175 0.691301 "iterations=1 substeps=16"
13.1281 0.0381163 "iterations=1 substeps=64"
END
$curve14 << END
11.2515 0.00184529 "substeps=207"
17.2608 0.00184665 "substeps=318"
34.8296 0.00184456 "substeps=635"
END
$curve15 << END
15.3887 0.00189404 "substeps=207"
47.0981 0.00185973 "substeps=635"
END
$curve16 << END
263.328 0.0867385 "one factorisation a step"
END
$default << END
0.753214 0.00340734 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-dress-energy.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
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
set output 'accuracy-dress-energy.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
