set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0882504:327.646]
set yrange [2.69841:472.896]
set title 'Hung sheet in wind, 64 × 64 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.144524 269.964 "iterations=1"
0.182098 295.56 "iterations=3"
0.272342 218.226 "iterations=7"
0.319835 130.509 "iterations=15"
0.564972 72.6051 "iterations=31"
0.927915 33.1026 "iterations=63"
1.75614 38.1885 "iterations=127"
3.35081 40.1605 "iterations=255"
END
$curve1 << END
0.126072 125.469 "iterations=2"
0.197894 272.691 "iterations=8"
0.300009 262.629 "iterations=16"
0.910649 53.6807 "iterations=64"
END
$curve2 << END
0.152808 146.004 "iterations=1"
0.216632 162.345 "iterations=7"
0.51648 92.1437 "iterations=31"
1.75347 37.0431 "iterations=127"
END
$curve3 << END
0.179508 151.938 "iterations=4"
0.252825 59.0373 "iterations=8"
0.330129 38.762 "iterations=16"
0.525686 26.6673 "iterations=32"
1.17221 31.5117 "iterations=64"
1.96999 32.5905 "iterations=128"
END
$curve4 << END
0.20826 170.895 "iterations=4"
0.33934 50.5177 "iterations=8"
0.577442 42.1365 "iterations=16"
1.08252 27.8534 "iterations=32"
2.20435 33.5407 "iterations=64"
4.08268 32.7714 "iterations=128"
END
$curve5 << END
0.32264 31.5967 "iterations=1"
0.43527 29.5853 "iterations=2"
0.584969 21.3728 "iterations=3"
0.723517 19.2479 "iterations=4"
1.01554 16.0031 "iterations=6"
1.22843 18.1436 "iterations=8"
2.10526 15.8763 "iterations=12"
2.713 13.6117 "iterations=16"
END
$curve6 << END
0.322392 31.5114 "iterations=1"
0.384653 22.7831 "iterations=2"
0.632787 19.4575 "iterations=4"
1.15231 17.5586 "iterations=8"
END
$curve7 << END
0.469893 27.6393 "passes=2 iterations=1"
0.573597 22.317 "passes=3 iterations=1"
0.583669 22.5492 "passes=2 iterations=2"
0.696086 15.6914 "passes=3 iterations=2"
0.697873 21.2386 "passes=2 iterations=4"
0.817821 18.3952 "passes=4 iterations=1"
0.910451 19.6839 "passes=2 iterations=6"
0.952236 18.4019 "passes=4 iterations=2"
0.992976 19.2538 "passes=3 iterations=4"
1.00982 19.2725 "passes=6 iterations=1"
1.21429 18.4636 "passes=3 iterations=6"
1.29128 16.403 "passes=4 iterations=4"
1.35634 14.0301 "passes=6 iterations=2"
1.58673 16.5547 "passes=8 iterations=1"
1.66978 11.2836 "passes=8 iterations=2"
END
$curve8 << END
0.400013 20.6879 "passes=1 iterations=2"
0.60241 17.3381 "passes=2 iterations=2"
0.753112 18.1475 "passes=3 iterations=2"
0.935222 15.3343 "passes=4 iterations=2"
1.08006 15.2308 "passes=4 iterations=4"
1.37462 8.35553 "passes=6 iterations=4"
END
$curve9 << END
204.779 32.7242 "one factorisation a step"
END
$curve10 << END
1.00318 29.6091 "passes=1 iterations=2"
1.40712 12.603 "passes=2 iterations=2"
1.81177 9.00934 "passes=3 iterations=2"
1.97871 6.20095 "passes=4 iterations=2"
2.83097 3.85487 "passes=6 iterations=2"
END
$default << END
0.696086 15.6914 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-64-own-1s.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-64-own-1s.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
