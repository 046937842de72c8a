set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0952371:465.25]
set yrange [0.00240436:4.8175]
set title 'Dress hung by its neck, 4589 particles: energy left above the converged step' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'energy gap over that of the inertial start'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 5
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 1504; weft_study accuracy, then weft_study plot' at screen 0.012, screen 0.022 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.136053 3.01094 "substeps=1"
0.166129 0.519799 "iterations=1"
0.212167 0.463576 "iterations=3"
0.248013 0.449498 "iterations=4"
0.256567 0.329927 "iterations=4"
0.371682 0.0545598 "iterations=1"
0.572012 0.0353057 "iterations=2"
0.652454 0.0184891 "passes=2 iterations=1"
0.750901 0.0144573 "passes=2 iterations=2"
0.843474 0.0118548 "passes=3 iterations=1"
1.0094 0.0100141 "passes=3 iterations=2"
1.02497 0.00940349 "passes=4 iterations=1"
1.19997 0.00793036 "passes=4 iterations=2"
1.53967 0.00691702 "passes=4 iterations=4"
1.92689 0.00428639 "passes=8 iterations=1"
2.03068 0.0034348 "passes=8 iterations=2"
END
$curve0 << END
0.166129 0.519799 "iterations=1"
0.212167 0.463576 "iterations=3"
0.320798 0.396658 "iterations=7"
0.53437 0.325908 "iterations=15"
0.983308 0.251253 "iterations=31"
1.79544 0.181164 "iterations=63"
3.48995 0.136976 "iterations=127"
6.86341 0.116049 "iterations=255"
END
$curve1 << END
0.180147 0.970365 "iterations=2"
0.350964 0.520722 "iterations=8"
0.540259 0.365049 "iterations=16"
1.75964 0.180094 "iterations=64"
END
$curve2 << END
0.170932 0.643593 "iterations=1"
0.306354 0.521569 "iterations=7"
0.968358 0.377132 "iterations=31"
3.82844 0.262999 "iterations=127"
END
$curve3 << END
0.66159 0.0655648 "iterations=7 substeps=2"
1.19202 0.0170178 "iterations=7 substeps=4"
2.52254 0.0107297 "iterations=7 substeps=8"
4.99381 0.00841547 "iterations=7 substeps=16"
END
$curve4 << END
0.256567 0.329927 "iterations=4"
0.385347 0.233183 "iterations=8"
0.607529 0.135035 "iterations=16"
1.08275 0.110351 "iterations=32"
1.88507 0.101988 "iterations=64"
3.36818 0.0837603 "iterations=128"
END
$curve5 << END
0.248013 0.449498 "iterations=4"
0.43118 0.262794 "iterations=8"
0.850887 0.128676 "iterations=16"
1.60204 0.104243 "iterations=32"
2.90066 0.0869258 "iterations=64"
5.80386 0.0823777 "iterations=128"
END
$curve6 << END
0.495998 0.0545598 "iterations=1"
0.727257 0.0296365 "iterations=2"
0.964614 0.0256182 "iterations=3"
1.18579 0.0217346 "iterations=4"
1.47775 0.0137258 "iterations=6"
2.12416 0.011932 "iterations=8"
2.79474 0.00840614 "iterations=12"
3.48685 0.00630207 "iterations=16"
END
$curve7 << END
0.371682 0.0545598 "iterations=1"
0.572012 0.0353057 "iterations=2"
0.827046 0.030541 "iterations=4"
1.42937 0.0294447 "iterations=8"
END
$curve8 << END
0.652454 0.0184891 "passes=2 iterations=1"
0.750901 0.0144573 "passes=2 iterations=2"
0.843474 0.0118548 "passes=3 iterations=1"
1.0094 0.0100141 "passes=3 iterations=2"
1.02497 0.00940349 "passes=4 iterations=1"
1.1812 0.0121105 "passes=2 iterations=4"
1.19997 0.00793036 "passes=4 iterations=2"
1.3097 0.00858184 "passes=3 iterations=4"
1.32314 0.00886917 "passes=6 iterations=1"
1.37404 0.0114298 "passes=2 iterations=6"
1.52683 0.0125483 "passes=6 iterations=2"
1.53967 0.00691702 "passes=4 iterations=4"
1.58278 0.00805334 "passes=3 iterations=6"
1.92689 0.00428639 "passes=8 iterations=1"
2.03068 0.0034348 "passes=8 iterations=2"
END
$curve9 << END
0.741369 0.0209358 "passes=1 substeps=2"
1.39002 0.0101967 "passes=1 substeps=4"
2.7793 0.0068648 "passes=1 substeps=8"
5.58172 0.00476916 "passes=1 substeps=16"
END
$curve10 << END
0.136053 3.01094 "substeps=1"
0.255947 2.87355 "substeps=2"
0.50531 2.47528 "substeps=4"
1.05831 1.60127 "substeps=8"
1.93954 0.699074 "substeps=16"
3.93763 0.205731 "substeps=32"
7.78242 0.0517731 "substeps=64"
END
$curve11 << END
0.658992 2.50929 "iterations=4"
1.44161 2.11787 "iterations=16"
5.56128 1.32406 "iterations=64"
END
$curve12 << END
0.286328 2.45922 "iterations=1"
0.938956 1.81553 "iterations=4"
3.71457 1.44438 "iterations=16"
14.8642 0.796165 "iterations=64"
END
$curve13 << END
1.13165 1.53702 "iterations=1 substeps=4"
4.21802 0.422662 "iterations=1 substeps=16"
17.4435 0.0254173 "iterations=1 substeps=64"
END
$curve14 << END
14.0433 0.00510543 "substeps=207"
21.5454 0.00510784 "substeps=318"
43.4874 0.00511048 "substeps=635"
END
$curve15 << END
17.6157 0.00514511 "substeps=207"
59.494 0.00503542 "substeps=635"
END
$curve16 << END
290.781 0.0814297 "one factorisation a step"
END
$default << END
1.0094 0.0100141 "passes=3 iterations=2"
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
