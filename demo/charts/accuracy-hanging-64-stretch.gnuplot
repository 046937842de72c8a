set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0783734:373.478]
set yrange [1.16116:19889.1]
set title 'Sheet hung by two corners, 64 × 64 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.111962 324.559 "iterations=1"
0.141157 460.355 "iterations=3"
0.210721 509.359 "iterations=7"
0.316762 375.268 "iterations=15"
0.54612 160.937 "iterations=31"
0.91869 79.053 "iterations=63"
1.66683 41.056 "iterations=127"
3.27224 32.9803 "iterations=255"
END
$curve1 << END
0.112371 1583.37 "iterations=2"
0.192032 415.022 "iterations=8"
0.321974 409.362 "iterations=16"
0.893651 154.014 "iterations=64"
END
$curve2 << END
0.134787 22.3971 "iterations=1"
0.204678 29.4997 "iterations=7"
0.511017 1.6588 "iterations=31"
1.776 4.22383 "iterations=127"
END
$curve3 << END
0.343461 215.206 "iterations=7 substeps=2"
0.693706 90.6905 "iterations=7 substeps=4"
1.39579 3.23907 "iterations=7 substeps=8"
2.70461 16.1022 "iterations=7 substeps=16"
END
$curve4 << END
0.14448 194.725 "iterations=4"
0.19326 150.883 "iterations=8"
0.291977 57.5873 "iterations=16"
0.520393 14.6135 "iterations=32"
0.896083 9.08688 "iterations=64"
1.67674 7.35651 "iterations=128"
END
$curve5 << END
0.1809 286.141 "iterations=4"
0.302027 148.865 "iterations=8"
0.549477 11.658 "iterations=16"
1.05718 10.413 "iterations=32"
2.06211 9.37189 "iterations=64"
4.08178 7.02205 "iterations=128"
END
$curve6 << END
0.315632 7.93845 "iterations=1"
0.430896 6.36576 "iterations=2"
0.592951 7.1541 "iterations=3"
0.73466 7.01301 "iterations=4"
0.987082 7.155 "iterations=6"
1.22965 7.13315 "iterations=8"
1.82281 7.65773 "iterations=12"
2.29564 7.72058 "iterations=16"
END
$curve7 << END
0.23618 7.80978 "iterations=1"
0.330875 6.10623 "iterations=2"
0.512334 7.20921 "iterations=4"
0.875454 7.51827 "iterations=8"
END
$curve8 << END
0.385769 6.07042 "passes=2 iterations=1"
0.459097 7.49677 "passes=2 iterations=2"
0.508157 6.93342 "passes=3 iterations=1"
0.611891 7.64495 "passes=3 iterations=2"
0.640371 7.06606 "passes=4 iterations=1"
0.652214 7.37911 "passes=2 iterations=4"
0.727416 8.14801 "passes=4 iterations=2"
0.848337 7.72181 "passes=3 iterations=4"
0.892351 7.33609 "passes=2 iterations=6"
0.911425 7.61909 "passes=6 iterations=1"
0.914295 7.86575 "passes=4 iterations=4"
0.967231 7.74504 "passes=3 iterations=6"
1.00383 8.15399 "passes=6 iterations=2"
1.21324 7.89835 "passes=8 iterations=1"
1.31492 8.04407 "passes=8 iterations=2"
END
$curve9 << END
0.474234 6.13219 "passes=1 substeps=2"
0.935376 8.03155 "passes=1 substeps=4"
1.86905 8.02331 "passes=1 substeps=8"
3.61089 7.83995 "passes=1 substeps=16"
END
$curve10 << END
0.334725 9.81509 "passes=1 iterations=2"
0.466479 7.53104 "passes=2 iterations=2"
0.61085 5.55265 "passes=3 iterations=2"
0.753085 5.1046 "passes=4 iterations=2"
0.94433 3.71973 "passes=4 iterations=4"
1.21031 3.95267 "passes=6 iterations=4"
END
$curve11 << END
1.20437 4.6944 "passes=3 substeps=2"
2.91759 6.42446 "passes=3 substeps=4"
4.76098 7.40174 "passes=3 substeps=8"
END
$curve12 << END
0.11486 12430.7 "substeps=1"
0.218748 7669.38 "substeps=2"
0.416158 1382.05 "substeps=4"
0.820646 240.566 "substeps=8"
1.64263 37.6224 "substeps=16"
3.23724 20.27 "substeps=32"
6.47651 9.94464 "substeps=64"
END
$curve13 << END
0.323777 7415.63 "iterations=4"
1.19499 1113.92 "iterations=16"
4.66415 176.121 "iterations=64"
END
$curve14 << END
0.352783 7701.05 "iterations=4"
1.18705 880.642 "iterations=16"
4.82033 137.745 "iterations=64"
END
$curve15 << END
1.7623 28.6149 "iterations=1 substeps=16"
6.89515 15.8775 "iterations=1 substeps=64"
END
$curve16 << END
8.3032 7.88087 "substeps=213"
11.4982 7.97504 "substeps=328"
23.5434 8.36064 "substeps=655"
END
$curve17 << END
12.8934 13.4306 "substeps=213"
39.885 8.70873 "substeps=655"
END
$curve18 << END
233.424 7.13232 "one factorisation a step"
END
$curve19 << END
0.734786 15.3667 "passes=1 iterations=2"
1.00188 14.4726 "passes=2 iterations=2"
1.32901 14.6238 "passes=3 iterations=2"
1.61981 15.4159 "passes=4 iterations=2"
2.24029 15.7219 "passes=6 iterations=2"
END
$default << END
0.611891 7.64495 "passes=3 iterations=2"
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
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $curve19 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
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
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $curve19 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
