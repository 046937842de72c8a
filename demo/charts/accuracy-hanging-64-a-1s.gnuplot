set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0783734:373.478]
set yrange [1.63013:5975.18]
set title 'Sheet hung by two corners, 64 × 64 particles: distance from converged backward Euler after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.111962 1130.66 "iterations=1"
0.112371 1089.23 "iterations=2"
0.134787 883.531 "iterations=1"
0.204678 751.388 "iterations=7"
0.23618 115.49 "iterations=1"
0.315632 114.941 "iterations=1"
0.330875 36.41 "iterations=2"
0.385769 34.0076 "passes=2 iterations=1"
0.430896 31.2996 "iterations=2"
0.459097 11.0124 "passes=2 iterations=2"
0.611891 8.61988 "passes=3 iterations=2"
0.652214 4.22172 "passes=2 iterations=4"
0.727416 4.0418 "passes=4 iterations=2"
0.848337 3.73352 "passes=3 iterations=4"
0.914295 2.54696 "passes=4 iterations=4"
1.31492 2.32876 "passes=8 iterations=2"
END
$curve0 << END
0.111962 1130.66 "iterations=1"
0.141157 1195.8 "iterations=3"
0.210721 1198.05 "iterations=7"
0.316762 1111.4 "iterations=15"
0.54612 977.972 "iterations=31"
0.91869 799.149 "iterations=63"
1.66683 678.758 "iterations=127"
3.27224 570.547 "iterations=255"
END
$curve1 << END
0.112371 1089.23 "iterations=2"
0.192032 1097.64 "iterations=8"
0.321974 1008.97 "iterations=16"
0.893651 746.111 "iterations=64"
END
$curve2 << END
0.134787 883.531 "iterations=1"
0.204678 751.388 "iterations=7"
0.511017 584.832 "iterations=31"
1.776 427.646 "iterations=127"
END
$curve3 << END
0.343461 949.291 "iterations=7 substeps=2"
0.693706 554.357 "iterations=7 substeps=4"
1.39579 146.431 "iterations=7 substeps=8"
2.70461 103.882 "iterations=7 substeps=16"
END
$curve4 << END
0.14448 1079.02 "iterations=4"
0.19326 913.799 "iterations=8"
0.291977 642.502 "iterations=16"
0.520393 355.264 "iterations=32"
0.896083 134.476 "iterations=64"
1.67674 36.7358 "iterations=128"
END
$curve5 << END
0.1809 1107.81 "iterations=4"
0.302027 907.392 "iterations=8"
0.549477 669.86 "iterations=16"
1.05718 388.118 "iterations=32"
2.06211 158.243 "iterations=64"
4.08178 90.7797 "iterations=128"
END
$curve6 << END
0.315632 114.941 "iterations=1"
0.430896 31.2996 "iterations=2"
0.592951 22.2365 "iterations=3"
0.73466 12.9032 "iterations=4"
0.987082 10.77 "iterations=6"
1.22965 21.1235 "iterations=8"
1.82281 3.80545 "iterations=12"
2.29564 4.1556 "iterations=16"
END
$curve7 << END
0.23618 115.49 "iterations=1"
0.330875 36.41 "iterations=2"
0.512334 29.9974 "iterations=4"
0.875454 22.4795 "iterations=8"
END
$curve8 << END
0.385769 34.0076 "passes=2 iterations=1"
0.459097 11.0124 "passes=2 iterations=2"
0.508157 24.9325 "passes=3 iterations=1"
0.611891 8.61988 "passes=3 iterations=2"
0.640371 14.1966 "passes=4 iterations=1"
0.652214 4.22172 "passes=2 iterations=4"
0.727416 4.0418 "passes=4 iterations=2"
0.848337 3.73352 "passes=3 iterations=4"
0.892351 3.9142 "passes=2 iterations=6"
0.911425 7.79408 "passes=6 iterations=1"
0.914295 2.54696 "passes=4 iterations=4"
0.967231 2.99268 "passes=3 iterations=6"
1.00383 2.61104 "passes=6 iterations=2"
1.21324 3.3212 "passes=8 iterations=1"
1.31492 2.32876 "passes=8 iterations=2"
END
$curve9 << END
0.474234 38.9085 "passes=1 substeps=2"
0.935376 51.2523 "passes=1 substeps=4"
1.86905 97.3397 "passes=1 substeps=8"
3.61089 128.544 "passes=1 substeps=16"
END
$curve10 << END
0.334725 169.516 "passes=1 iterations=2"
0.466479 161.798 "passes=2 iterations=2"
0.61085 168.517 "passes=3 iterations=2"
0.753085 168.426 "passes=4 iterations=2"
0.94433 173.42 "passes=4 iterations=4"
1.21031 174.727 "passes=6 iterations=4"
END
$curve11 << END
1.20437 170.11 "passes=3 substeps=2"
2.91759 178.984 "passes=3 substeps=4"
4.76098 177.597 "passes=3 substeps=8"
END
$curve12 << END
0.11486 3734.49 "substeps=1"
0.218748 2417.96 "substeps=2"
0.416158 675.267 "substeps=4"
0.820646 138.955 "substeps=8"
1.64263 144.312 "substeps=16"
3.23724 170.038 "substeps=32"
6.47651 175.644 "substeps=64"
END
$curve13 << END
0.323777 2347.33 "iterations=4"
1.19499 590.758 "iterations=16"
4.66415 102.967 "iterations=64"
END
$curve14 << END
0.352783 1717.46 "iterations=4"
1.18705 317.583 "iterations=16"
4.82033 56.7155 "iterations=64"
END
$curve15 << END
1.7623 179.347 "iterations=1 substeps=16"
6.89515 178.741 "iterations=1 substeps=64"
END
$curve16 << END
8.3032 179.482 "substeps=213"
11.4982 178.989 "substeps=328"
23.5434 178.743 "substeps=655"
END
$curve17 << END
12.8934 193.272 "substeps=213"
39.885 181.859 "substeps=655"
END
$curve18 << END
233.424 96.8369 "one factorisation a step"
END
$default << END
0.611891 8.61988 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-64-a-1s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  96.8635 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-64-a-1s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  96.8635 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
