set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0489195:323.125]
set yrange [1.39523:19889.1]
set title 'Sheet hung by two corners, 64 × 64 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit d3fa699+; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.069885 324.848 "iterations=1"
0.086641 460.663 "iterations=3"
0.12624 509.753 "iterations=7"
0.203647 375.074 "iterations=15"
0.349419 160.843 "iterations=31"
0.664564 79.0787 "iterations=63"
1.28113 41.0745 "iterations=127"
2.51178 32.9735 "iterations=255"
END
$curve1 << END
0.074708 1940.71 "iterations=2"
0.130516 560.358 "iterations=8"
0.205013 400.824 "iterations=16"
0.667548 156.909 "iterations=64"
END
$curve2 << END
0.09468 24.5594 "iterations=1"
0.153038 20.7032 "iterations=7"
0.382016 1.99319 "iterations=31"
1.30798 4.17253 "iterations=127"
END
$curve3 << END
0.236085 215.213 "iterations=7 substeps=2"
0.46997 90.9639 "iterations=7 substeps=4"
0.920289 3.10092 "iterations=7 substeps=8"
1.85456 15.9802 "iterations=7 substeps=16"
END
$curve4 << END
0.105357 192.971 "iterations=4"
0.14366 138.696 "iterations=8"
0.222056 62.2851 "iterations=16"
0.384137 14.8404 "iterations=32"
0.709841 9.14029 "iterations=64"
1.3558 7.05055 "iterations=128"
END
$curve5 << END
0.137723 278.16 "iterations=4"
0.244334 145.97 "iterations=8"
0.458177 22.2107 "iterations=16"
0.908229 9.01108 "iterations=32"
1.81957 9.08375 "iterations=64"
3.74308 7.05736 "iterations=128"
END
$curve6 << END
0.258603 7.68282 "iterations=1"
0.33062 6.1181 "iterations=2"
0.402423 6.70148 "iterations=3"
0.546333 6.8653 "iterations=4"
0.750629 7.27245 "iterations=6"
0.948686 7.73468 "iterations=8"
1.32819 7.52553 "iterations=12"
1.7154 7.67855 "iterations=16"
END
$curve7 << END
0.176951 7.87491 "iterations=1"
0.246563 6.06545 "iterations=2"
0.382044 7.21726 "iterations=4"
0.685483 7.40706 "iterations=8"
END
$curve8 << END
0.259558 6.10222 "passes=2 iterations=1"
0.338629 7.36497 "passes=2 iterations=2"
0.344936 6.82642 "passes=3 iterations=1"
0.41763 7.69024 "passes=3 iterations=2"
0.439137 7.06859 "passes=4 iterations=1"
0.472378 7.37637 "passes=2 iterations=4"
0.508498 8.15346 "passes=4 iterations=2"
0.600973 7.70303 "passes=3 iterations=4"
0.618281 7.32612 "passes=2 iterations=6"
0.620455 7.62101 "passes=6 iterations=1"
0.647766 7.87234 "passes=4 iterations=4"
0.697665 8.08656 "passes=6 iterations=2"
0.756293 7.74575 "passes=3 iterations=6"
0.802783 7.89924 "passes=8 iterations=1"
0.865057 8.03648 "passes=8 iterations=2"
END
$curve9 << END
0.344757 6.5509 "passes=1 substeps=2"
0.689148 8.32771 "passes=1 substeps=4"
1.42172 7.89844 "passes=1 substeps=8"
2.77164 7.72318 "passes=1 substeps=16"
END
$curve10 << END
0.257298 8.65848 "passes=1 iterations=2"
0.341816 7.47824 "passes=2 iterations=2"
0.432435 5.74205 "passes=3 iterations=2"
0.523549 4.59449 "passes=4 iterations=2"
0.683376 3.79461 "passes=4 iterations=4"
0.847334 4.10561 "passes=6 iterations=4"
END
$curve11 << END
0.882076 4.58131 "passes=3 substeps=2"
1.73758 6.39074 "passes=3 substeps=4"
3.506 7.0119 "passes=3 substeps=8"
END
$curve12 << END
0.733165 15.4928 "passes=1 iterations=2"
0.990487 14.5054 "passes=2 iterations=2"
1.28655 14.6373 "passes=3 iterations=2"
1.55775 15.3982 "passes=4 iterations=2"
2.05489 15.7176 "passes=6 iterations=2"
END
$curve13 << END
0.108646 12430.7 "substeps=1"
0.208106 7669.38 "substeps=2"
0.40984 1382.05 "substeps=4"
0.81196 240.566 "substeps=8"
1.63405 37.6224 "substeps=16"
3.26307 20.27 "substeps=32"
6.49249 9.94464 "substeps=64"
END
$curve14 << END
0.328626 7415.63 "iterations=4"
1.1943 1113.92 "iterations=16"
4.72639 176.121 "iterations=64"
END
$curve15 << END
0.343851 7701.05 "iterations=4"
1.19404 880.642 "iterations=16"
4.51877 137.745 "iterations=64"
END
$curve16 << END
1.68889 28.6149 "iterations=1 substeps=16"
6.81667 15.8775 "iterations=1 substeps=64"
END
$curve17 << END
5.72069 8.24592 "substeps=213"
8.79084 8.57579 "substeps=328"
17.4419 8.83227 "substeps=655"
END
$curve18 << END
10.7062 11.8194 "substeps=213"
32.4487 9.54919 "substeps=655"
END
$curve19 << END
201.953 7.1278 "one factorisation a step"
END
$default << END
0.41763 7.69024 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-64-stretch.svg'
plot 8.10904 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve19 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-64-stretch.png'
plot 8.10904 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve19 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
