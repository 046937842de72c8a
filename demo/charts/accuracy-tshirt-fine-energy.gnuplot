set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.299466:3154.11]
set yrange [0.00104973:3.30627]
set title 'T-shirt hung by its neck, 14048 particles: energy left above the converged step' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'energy gap over that of the inertial start'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 5
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 11579; weft_study accuracy, then weft_study plot' at screen 0.012, screen 0.022 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.427809 1.06257 "substeps=1"
0.489107 0.779129 "iterations=1"
0.591996 0.385922 "iterations=4"
0.86306 0.269886 "iterations=8"
1.09435 0.0225037 "iterations=1"
1.42744 0.0127251 "iterations=2"
1.88948 0.00667995 "passes=2 iterations=1"
1.9389 0.00525639 "passes=2 iterations=2"
2.01758 0.00426461 "passes=3 iterations=1"
2.5868 0.00360319 "passes=3 iterations=2"
2.58747 0.00351162 "passes=4 iterations=1"
3.2371 0.00305231 "passes=4 iterations=2"
3.79569 0.00292935 "passes=3 iterations=6"
4.6169 0.00269945 "passes=4 iterations=4"
5.47684 0.00266641 "passes=8 iterations=2"
6.31252 0.00260054 "passes=6 iterations=2"
7.58013 0.00250174 "passes=1 substeps=8"
14.9019 0.00194352 "passes=1 substeps=16"
538.31 0.00149961 "substeps=3040"
END
$curve0 << END
0.489107 0.779129 "iterations=1"
0.641293 0.751851 "iterations=3"
0.915619 0.541318 "iterations=7"
1.53938 0.345299 "iterations=15"
2.83656 0.247206 "iterations=31"
5.5023 0.190834 "iterations=63"
9.91574 0.159184 "iterations=127"
18.9936 0.136346 "iterations=255"
END
$curve1 << END
0.553868 2.06642 "iterations=2"
1.07029 0.606373 "iterations=8"
1.99418 0.311747 "iterations=16"
5.67879 0.184344 "iterations=64"
END
$curve2 << END
0.494642 0.816082 "iterations=1"
0.942846 0.578419 "iterations=7"
2.6474 0.284323 "iterations=31"
8.27577 0.196365 "iterations=127"
END
$curve3 << END
1.50371 0.0407403 "iterations=7 substeps=2"
2.9336 0.00880233 "iterations=7 substeps=4"
6.74113 0.00473396 "iterations=7 substeps=8"
13.2928 0.00327036 "iterations=7 substeps=16"
END
$curve4 << END
0.591996 0.385922 "iterations=4"
0.86306 0.269886 "iterations=8"
1.47748 0.189005 "iterations=16"
2.77239 0.140171 "iterations=32"
5.45302 0.0685245 "iterations=64"
10.8697 0.0520646 "iterations=128"
END
$curve5 << END
0.90104 0.705771 "iterations=4"
1.34957 0.343307 "iterations=8"
2.41302 0.151218 "iterations=16"
4.41327 0.113751 "iterations=32"
8.00856 0.0564688 "iterations=64"
15.2209 0.0396645 "iterations=128"
END
$curve6 << END
1.24227 0.0225037 "iterations=1"
2.37013 0.0180549 "iterations=2"
3.01387 0.0104333 "iterations=3"
3.49988 0.00805309 "iterations=4"
5.25872 0.00757958 "iterations=6"
6.77402 0.00748928 "iterations=8"
9.36239 0.00708747 "iterations=12"
11.7111 0.00638407 "iterations=16"
END
$curve7 << END
1.09435 0.0225037 "iterations=1"
1.42744 0.0127251 "iterations=2"
2.10588 0.0109102 "iterations=4"
3.60014 0.010575 "iterations=8"
END
$curve8 << END
1.88948 0.00667995 "passes=2 iterations=1"
1.9389 0.00525639 "passes=2 iterations=2"
2.01758 0.00426461 "passes=3 iterations=1"
2.53353 0.0044595 "passes=2 iterations=4"
2.5868 0.00360319 "passes=3 iterations=2"
2.58747 0.00351162 "passes=4 iterations=1"
3.2371 0.00305231 "passes=4 iterations=2"
3.79569 0.00292935 "passes=3 iterations=6"
3.85421 0.00312402 "passes=3 iterations=4"
4.02388 0.00421236 "passes=2 iterations=6"
4.6169 0.00269945 "passes=4 iterations=4"
5.0354 0.0029689 "passes=6 iterations=1"
5.13796 0.00271699 "passes=8 iterations=1"
5.47684 0.00266641 "passes=8 iterations=2"
6.31252 0.00260054 "passes=6 iterations=2"
END
$curve9 << END
2.8133 0.00801817 "passes=1 substeps=2"
3.93791 0.00360044 "passes=1 substeps=4"
7.58013 0.00250174 "passes=1 substeps=8"
14.9019 0.00194352 "passes=1 substeps=16"
END
$curve10 << END
0.427809 1.06257 "substeps=1"
0.755987 0.840722 "substeps=2"
1.10567 0.690469 "substeps=4"
2.13677 0.536337 "substeps=8"
4.12125 0.395752 "substeps=16"
9.09258 0.233019 "substeps=32"
15.5905 0.0968959 "substeps=64"
END
$curve11 << END
0.840963 0.682634 "iterations=4"
3.10746 0.577739 "iterations=16"
12.1117 0.499261 "iterations=64"
END
$curve12 << END
0.866309 0.930653 "iterations=1"
2.76879 0.499131 "iterations=4"
10.7673 0.38121 "iterations=16"
42.3809 0.278272 "iterations=64"
END
$curve13 << END
3.09443 0.384163 "iterations=1 substeps=4"
12.1172 0.189227 "iterations=1 substeps=16"
48.6219 0.0481744 "iterations=1 substeps=64"
END
$curve14 << END
538.31 0.00149961 "substeps=3040"
818.553 0.00150124 "substeps=4677"
1864.35 0.00151405 "substeps=9353"
END
$curve15 << END
622.884 0.0015009 "substeps=3040"
1971.32 0.00151436 "substeps=9353"
END
$default << END
2.5868 0.00360319 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-tshirt-fine-energy.svg'
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
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-tshirt-fine-energy.png'
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
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
