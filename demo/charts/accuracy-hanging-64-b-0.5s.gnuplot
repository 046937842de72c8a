set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0783734:373.478]
set yrange [0.468623:1434.39]
set title 'Sheet hung by two corners, 64 × 64 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.111962 664.542 "iterations=1"
0.112371 644.984 "iterations=2"
0.134787 623.112 "iterations=1"
0.141157 622.586 "iterations=3"
0.192032 591.253 "iterations=8"
0.204678 534.159 "iterations=7"
0.23618 53.816 "iterations=1"
0.315632 53.7913 "iterations=1"
0.330875 50.8227 "iterations=2"
0.334725 35.8526 "passes=1 iterations=2"
0.466479 22.9398 "passes=2 iterations=2"
0.753085 20.8139 "passes=4 iterations=2"
0.94433 20.6885 "passes=4 iterations=4"
1.20437 11.3517 "passes=3 substeps=2"
2.91759 5.17181 "passes=3 substeps=4"
4.76098 2.63197 "passes=3 substeps=8"
8.3032 0.802214 "substeps=213"
11.4982 0.669461 "substeps=328"
END
$curve0 << END
0.111962 664.542 "iterations=1"
0.141157 622.586 "iterations=3"
0.210721 607.979 "iterations=7"
0.316762 610.711 "iterations=15"
0.54612 617.115 "iterations=31"
0.91869 597.452 "iterations=63"
1.66683 557.097 "iterations=127"
3.27224 491.388 "iterations=255"
END
$curve1 << END
0.112371 644.984 "iterations=2"
0.192032 591.253 "iterations=8"
0.321974 549.898 "iterations=16"
0.893651 577.552 "iterations=64"
END
$curve2 << END
0.134787 623.112 "iterations=1"
0.204678 534.159 "iterations=7"
0.511017 465.932 "iterations=31"
1.776 401.418 "iterations=127"
END
$curve3 << END
0.343461 605.245 "iterations=7 substeps=2"
0.693706 509.177 "iterations=7 substeps=4"
1.39579 348.891 "iterations=7 substeps=8"
2.70461 229.4 "iterations=7 substeps=16"
END
$curve4 << END
0.14448 651.463 "iterations=4"
0.19326 608.569 "iterations=8"
0.291977 531.931 "iterations=16"
0.520393 380.665 "iterations=32"
0.896083 194.384 "iterations=64"
1.67674 75.2543 "iterations=128"
END
$curve5 << END
0.1809 631.558 "iterations=4"
0.302027 596.083 "iterations=8"
0.549477 521.584 "iterations=16"
1.05718 347.23 "iterations=32"
2.06211 151.771 "iterations=64"
4.08178 82.9289 "iterations=128"
END
$curve6 << END
0.315632 53.7913 "iterations=1"
0.430896 52.0745 "iterations=2"
0.592951 50.1473 "iterations=3"
0.73466 49.4055 "iterations=4"
0.987082 43.8609 "iterations=6"
1.22965 51.4332 "iterations=8"
1.82281 46.0048 "iterations=12"
2.29564 44.3591 "iterations=16"
END
$curve7 << END
0.23618 53.816 "iterations=1"
0.330875 50.8227 "iterations=2"
0.512334 50.7471 "iterations=4"
0.875454 50.5325 "iterations=8"
END
$curve8 << END
0.385769 56.6211 "passes=2 iterations=1"
0.459097 38.8638 "passes=2 iterations=2"
0.508157 42.0085 "passes=3 iterations=1"
0.611891 40.2032 "passes=3 iterations=2"
0.640371 44.5921 "passes=4 iterations=1"
0.652214 41.2642 "passes=2 iterations=4"
0.727416 39.1171 "passes=4 iterations=2"
0.848337 40.0575 "passes=3 iterations=4"
0.892351 41.0916 "passes=2 iterations=6"
0.911425 41.1284 "passes=6 iterations=1"
0.914295 39.4487 "passes=4 iterations=4"
0.967231 39.886 "passes=3 iterations=6"
1.00383 38.9781 "passes=6 iterations=2"
1.21324 39.9199 "passes=8 iterations=1"
1.31492 38.9086 "passes=8 iterations=2"
END
$curve9 << END
0.474234 39.0336 "passes=1 substeps=2"
0.935376 27.029 "passes=1 substeps=4"
1.86905 19.0683 "passes=1 substeps=8"
3.61089 12.4804 "passes=1 substeps=16"
END
$curve10 << END
0.334725 35.8526 "passes=1 iterations=2"
0.466479 22.9398 "passes=2 iterations=2"
0.61085 23.5443 "passes=3 iterations=2"
0.753085 20.8139 "passes=4 iterations=2"
0.94433 20.6885 "passes=4 iterations=4"
1.21031 20.1841 "passes=6 iterations=4"
END
$curve11 << END
1.20437 11.3517 "passes=3 substeps=2"
2.91759 5.17181 "passes=3 substeps=4"
4.76098 2.63197 "passes=3 substeps=8"
END
$curve12 << END
0.11486 896.496 "substeps=1"
0.218748 793.578 "substeps=2"
0.416158 603.442 "substeps=4"
0.820646 343.057 "substeps=8"
1.64263 142.955 "substeps=16"
3.23724 70.5963 "substeps=32"
6.47651 35.6026 "substeps=64"
END
$curve13 << END
0.323777 791.941 "iterations=4"
1.19499 571.553 "iterations=16"
4.66415 291.08 "iterations=64"
END
$curve14 << END
0.352783 744.764 "iterations=4"
1.18705 496.065 "iterations=16"
4.82033 216.308 "iterations=64"
END
$curve15 << END
1.7623 91.2229 "iterations=1 substeps=16"
6.89515 15.3896 "iterations=1 substeps=64"
END
$curve16 << END
8.3032 0.802214 "substeps=213"
11.4982 0.669461 "substeps=328"
23.5434 0.844045 "substeps=655"
END
$curve17 << END
12.8934 11.8797 "substeps=213"
39.885 2.02137 "substeps=655"
END
$curve18 << END
233.424 82.3693 "one factorisation a step"
END
$default << END
0.611891 40.2032 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-64-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  38.9171 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.0102 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
set output 'accuracy-hanging-64-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  38.9171 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.0102 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
