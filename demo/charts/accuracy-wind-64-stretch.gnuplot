set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0882504:327.646]
set yrange [1.40474:9536.61]
set title 'Hung sheet in wind, 64 × 64 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.144524 226.561 "iterations=1"
0.182098 243.087 "iterations=3"
0.272342 190.968 "iterations=7"
0.319835 110.441 "iterations=15"
0.564972 66.2906 "iterations=31"
0.927915 29.5393 "iterations=63"
1.75614 9.3498 "iterations=127"
3.35081 8.96484 "iterations=255"
END
$curve1 << END
0.126072 497.25 "iterations=2"
0.197894 328.386 "iterations=8"
0.300009 235.358 "iterations=16"
0.910649 157.852 "iterations=64"
END
$curve2 << END
0.152808 55.7738 "iterations=1"
0.216632 39.3654 "iterations=7"
0.51648 3.42149 "iterations=31"
1.75347 2.00677 "iterations=127"
END
$curve3 << END
0.433444 73.3064 "iterations=7 substeps=2"
0.795507 10.4138 "iterations=7 substeps=4"
1.72956 24.4245 "iterations=7 substeps=8"
3.20135 19.5242 "iterations=7 substeps=16"
END
$curve4 << END
0.179508 128.227 "iterations=4"
0.252825 55.3477 "iterations=8"
0.330129 9.27238 "iterations=16"
0.525686 19.7049 "iterations=32"
1.17221 16.9015 "iterations=64"
1.96999 15.9388 "iterations=128"
END
$curve5 << END
0.20826 147.394 "iterations=4"
0.33934 50.418 "iterations=8"
0.577442 9.1642 "iterations=16"
1.08252 18.3121 "iterations=32"
2.20435 16.2446 "iterations=64"
4.08268 15.9132 "iterations=128"
END
$curve6 << END
0.32264 16.6237 "iterations=1"
0.43527 15.5009 "iterations=2"
0.584969 16.4068 "iterations=3"
0.723517 16.1284 "iterations=4"
1.01554 16.0552 "iterations=6"
1.22843 16.0042 "iterations=8"
2.10526 16.0468 "iterations=12"
2.713 16.0453 "iterations=16"
END
$curve7 << END
0.322392 16.6079 "iterations=1"
0.384653 15.7129 "iterations=2"
0.632787 15.6481 "iterations=4"
1.15231 15.5973 "iterations=8"
END
$curve8 << END
0.469893 16.1105 "passes=2 iterations=1"
0.573597 16.4685 "passes=3 iterations=1"
0.583669 16.5687 "passes=2 iterations=2"
0.696086 15.9887 "passes=3 iterations=2"
0.697873 15.808 "passes=2 iterations=4"
0.817821 16.0664 "passes=4 iterations=1"
0.910451 15.9946 "passes=2 iterations=6"
0.952236 15.8534 "passes=4 iterations=2"
0.992976 16.0201 "passes=3 iterations=4"
1.00982 15.7932 "passes=6 iterations=1"
1.21429 16.1713 "passes=3 iterations=6"
1.29128 16.255 "passes=4 iterations=4"
1.35634 16.3162 "passes=6 iterations=2"
1.58673 15.9161 "passes=8 iterations=1"
1.66978 16.3886 "passes=8 iterations=2"
END
$curve9 << END
0.516482 17.1595 "passes=1 substeps=2"
1.03364 16.7359 "passes=1 substeps=4"
2.0462 16.3455 "passes=1 substeps=8"
4.07905 16.5112 "passes=1 substeps=16"
END
$curve10 << END
0.400013 15.1795 "passes=1 iterations=2"
0.60241 16.2954 "passes=2 iterations=2"
0.753112 15.6812 "passes=3 iterations=2"
0.935222 15.9603 "passes=4 iterations=2"
1.08006 16.0332 "passes=4 iterations=4"
1.37462 16.2943 "passes=6 iterations=4"
END
$curve11 << END
1.491 16.7009 "passes=3 substeps=2"
2.88636 16.2927 "passes=3 substeps=4"
5.92314 16.6487 "passes=3 substeps=8"
END
$curve12 << END
0.142538 5960.38 "substeps=1"
0.244178 4189.1 "substeps=2"
0.49884 1317.78 "substeps=4"
1.01407 414.963 "substeps=8"
2.005 164.606 "substeps=16"
3.91791 89.2816 "substeps=32"
7.84685 47.9765 "substeps=64"
END
$curve13 << END
0.348506 3732.33 "iterations=4"
1.21967 921.733 "iterations=16"
4.60987 272.035 "iterations=64"
END
$curve14 << END
0.386099 4663.02 "iterations=4"
1.38225 867.393 "iterations=16"
5.23283 299.202 "iterations=64"
END
$curve15 << END
0.556964 1480.45 "iterations=1 substeps=4"
2.26575 153.731 "iterations=1 substeps=16"
8.69652 31.2707 "iterations=1 substeps=64"
END
$curve16 << END
11.3821 16.248 "substeps=213"
17.35 16.2971 "substeps=328"
34.2259 16.2093 "substeps=655"
END
$curve17 << END
15.2574 13.5831 "substeps=213"
46.9162 17.3003 "substeps=655"
END
$curve18 << END
204.779 15.9811 "one factorisation a step"
END
$curve19 << END
1.00318 35.4468 "passes=1 iterations=2"
1.40712 32.8971 "passes=2 iterations=2"
1.81177 32.8164 "passes=3 iterations=2"
1.97871 32.5727 "passes=4 iterations=2"
2.83097 32.4233 "passes=6 iterations=2"
END
$default << END
0.696086 15.9887 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-64-stretch.svg'
plot 16.546 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
set output 'accuracy-wind-64-stretch.png'
plot 16.546 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
