set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0489195:323.125]
set yrange [1.15454:1916.62]
set title 'Sheet hung by two corners, 64 × 64 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit d3fa699+; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.069885 1130.62 "iterations=1"
0.086641 1195.35 "iterations=3"
0.12624 1197.89 "iterations=7"
0.203647 1111.24 "iterations=15"
0.349419 977.773 "iterations=31"
0.664564 799.004 "iterations=63"
1.28113 678.552 "iterations=127"
2.51178 570.35 "iterations=255"
END
$curve1 << END
0.074708 1092.7 "iterations=2"
0.130516 1094.22 "iterations=8"
0.205013 1007.48 "iterations=16"
0.667548 741.2 "iterations=64"
END
$curve2 << END
0.09468 882.84 "iterations=1"
0.153038 743.569 "iterations=7"
0.382016 590.29 "iterations=31"
1.30798 427.915 "iterations=127"
END
$curve3 << END
0.105357 1078.62 "iterations=4"
0.14366 899.054 "iterations=8"
0.222056 642.343 "iterations=16"
0.384137 373.133 "iterations=32"
0.709841 141.241 "iterations=64"
1.3558 31.938 "iterations=128"
END
$curve4 << END
0.137723 1109.11 "iterations=4"
0.244334 918.264 "iterations=8"
0.458177 658.045 "iterations=16"
0.908229 391.875 "iterations=32"
1.81957 156.31 "iterations=64"
3.74308 90.3208 "iterations=128"
END
$curve5 << END
0.258603 110.258 "iterations=1"
0.33062 37.6248 "iterations=2"
0.402423 27.8523 "iterations=3"
0.546333 17.4838 "iterations=4"
0.750629 6.76004 "iterations=6"
0.948686 5.13381 "iterations=8"
1.32819 2.94229 "iterations=12"
1.7154 2.4597 "iterations=16"
END
$curve6 << END
0.176951 111.908 "iterations=1"
0.246563 36.4978 "iterations=2"
0.382044 30.1332 "iterations=4"
0.685483 26.405 "iterations=8"
END
$curve7 << END
0.259558 33.4895 "passes=2 iterations=1"
0.338629 13.0473 "passes=2 iterations=2"
0.344936 26.2334 "passes=3 iterations=1"
0.41763 6.70413 "passes=3 iterations=2"
0.439137 14.0273 "passes=4 iterations=1"
0.472378 3.94053 "passes=2 iterations=4"
0.508498 3.84396 "passes=4 iterations=2"
0.600973 3.30308 "passes=3 iterations=4"
0.618281 4.81004 "passes=2 iterations=6"
0.620455 7.06003 "passes=6 iterations=1"
0.647766 2.49658 "passes=4 iterations=4"
0.697665 1.93711 "passes=6 iterations=2"
0.756293 2.70333 "passes=3 iterations=6"
0.802783 2.83069 "passes=8 iterations=1"
0.865057 1.64935 "passes=8 iterations=2"
END
$curve8 << END
0.257298 46.5112 "passes=1 iterations=2"
0.341816 46.8413 "passes=2 iterations=2"
0.432435 25.4619 "passes=3 iterations=2"
0.523549 24.9792 "passes=4 iterations=2"
0.683376 21.541 "passes=4 iterations=4"
0.847334 19.1245 "passes=6 iterations=4"
END
$curve9 << END
0.733165 47.6038 "passes=1 iterations=2"
0.990487 28.5091 "passes=2 iterations=2"
1.28655 14.6782 "passes=3 iterations=2"
1.55775 8.62528 "passes=4 iterations=2"
2.05489 5.98831 "passes=6 iterations=2"
END
$curve10 << END
201.953 96.1886 "one factorisation a step"
END
$default << END
0.41763 6.70413 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-64-own-1s.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-64-own-1s.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
