set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0952371:465.25]
set yrange [0.380706:4.67171]
set ytics (0.5, 1, 2)
set title 'Dress hung by its neck, 4589 particles: distance from the converged step' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles after one step [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 5
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 1504; weft_study accuracy, then weft_study plot' at screen 0.012, screen 0.022 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.136053 2.91982 "substeps=1"
0.166129 1.27976 "iterations=1"
0.212167 1.2613 "iterations=3"
0.248013 1.22741 "iterations=4"
0.256567 1.1986 "iterations=4"
0.371682 1.00068 "iterations=1"
0.572012 0.943102 "iterations=2"
0.652454 0.926173 "passes=2 iterations=1"
0.750901 0.864337 "passes=2 iterations=2"
0.843474 0.860865 "passes=3 iterations=1"
1.0094 0.791469 "passes=3 iterations=2"
1.1812 0.747937 "passes=2 iterations=4"
1.19997 0.713179 "passes=4 iterations=2"
1.3097 0.652418 "passes=3 iterations=4"
1.52683 0.604019 "passes=6 iterations=2"
1.53967 0.584033 "passes=4 iterations=4"
1.58278 0.564017 "passes=3 iterations=6"
2.03068 0.543865 "passes=8 iterations=2"
END
$curve0 << END
0.166129 1.27976 "iterations=1"
0.212167 1.2613 "iterations=3"
0.320798 1.23342 "iterations=7"
0.53437 1.19555 "iterations=15"
0.983308 1.15368 "iterations=31"
1.79544 1.11527 "iterations=63"
3.48995 1.08525 "iterations=127"
6.86341 1.06412 "iterations=255"
END
$curve1 << END
0.180147 1.3064 "iterations=2"
0.350964 1.21504 "iterations=8"
0.540259 1.17851 "iterations=16"
1.75964 1.11361 "iterations=64"
END
$curve2 << END
0.170932 1.30427 "iterations=1"
0.306354 1.25905 "iterations=7"
0.968358 1.18132 "iterations=31"
3.82844 1.115 "iterations=127"
END
$curve3 << END
0.66159 1.14393 "iterations=7 substeps=2"
1.19202 1.07202 "iterations=7 substeps=4"
2.52254 0.946767 "iterations=7 substeps=8"
4.99381 0.786529 "iterations=7 substeps=16"
END
$curve4 << END
0.256567 1.1986 "iterations=4"
0.385347 1.15394 "iterations=8"
0.607529 1.0947 "iterations=16"
1.08275 1.09392 "iterations=32"
1.88507 1.18656 "iterations=64"
3.36818 1.1839 "iterations=128"
END
$curve5 << END
0.248013 1.22741 "iterations=4"
0.43118 1.15735 "iterations=8"
0.850887 1.10091 "iterations=16"
1.60204 1.09327 "iterations=32"
2.90066 1.14351 "iterations=64"
5.80386 1.1659 "iterations=128"
END
$curve6 << END
0.495998 1.00068 "iterations=1"
0.727257 0.948274 "iterations=2"
0.964614 0.937511 "iterations=3"
1.18579 0.921353 "iterations=4"
1.47775 0.859039 "iterations=6"
2.12416 0.83539 "iterations=8"
2.79474 0.786783 "iterations=12"
3.48685 0.715337 "iterations=16"
END
$curve7 << END
0.371682 1.00068 "iterations=1"
0.572012 0.943102 "iterations=2"
0.827046 0.887106 "iterations=4"
1.42937 0.856979 "iterations=8"
END
$curve8 << END
0.652454 0.926173 "passes=2 iterations=1"
0.750901 0.864337 "passes=2 iterations=2"
0.843474 0.860865 "passes=3 iterations=1"
1.0094 0.791469 "passes=3 iterations=2"
1.02497 0.807183 "passes=4 iterations=1"
1.1812 0.747937 "passes=2 iterations=4"
1.19997 0.713179 "passes=4 iterations=2"
1.3097 0.652418 "passes=3 iterations=4"
1.32314 0.724725 "passes=6 iterations=1"
1.37404 0.652493 "passes=2 iterations=6"
1.52683 0.604019 "passes=6 iterations=2"
1.53967 0.584033 "passes=4 iterations=4"
1.58278 0.564017 "passes=3 iterations=6"
1.92689 0.664918 "passes=8 iterations=1"
2.03068 0.543865 "passes=8 iterations=2"
END
$curve9 << END
0.741369 0.929777 "passes=1 substeps=2"
1.39002 0.830016 "passes=1 substeps=4"
2.7793 0.685327 "passes=1 substeps=8"
5.58172 0.603794 "passes=1 substeps=16"
END
$curve10 << END
0.136053 2.91982 "substeps=1"
0.255947 2.34735 "substeps=2"
0.50531 2.06388 "substeps=4"
1.05831 1.87204 "substeps=8"
1.93954 1.65846 "substeps=16"
3.93763 1.32477 "substeps=32"
7.78242 0.920449 "substeps=64"
END
$curve11 << END
0.658992 2.85509 "iterations=4"
1.44161 2.76062 "iterations=16"
5.56128 2.5578 "iterations=64"
END
$curve12 << END
0.286328 2.86867 "iterations=1"
0.938956 2.77457 "iterations=4"
3.71457 2.59184 "iterations=16"
14.8642 2.05024 "iterations=64"
END
$curve13 << END
1.13165 1.96014 "iterations=1 substeps=4"
4.21802 1.37931 "iterations=1 substeps=16"
17.4435 0.718568 "iterations=1 substeps=64"
END
$curve14 << END
14.0433 0.612061 "substeps=207"
21.5454 0.612465 "substeps=318"
43.4874 0.612628 "substeps=635"
END
$curve15 << END
17.6157 0.611169 "substeps=207"
59.494 0.612645 "substeps=635"
END
$curve16 << END
290.781 1.16789 "one factorisation a step"
END
$default << END
1.0094 0.791469 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-dress-step.svg'
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
set output 'accuracy-dress-step.png'
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
