set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.289804:863.368]
set yrange [1.69483:1488.07]
set title 'Sheet hung by two corners, 128 × 128 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1; Fibres and sets iterations=4' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.414006 930.046 "substeps=1"
0.465065 713.315 "iterations=1"
0.502672 700.793 "iterations=2"
0.591411 686.147 "iterations=3"
0.755605 671.959 "iterations=4"
0.833343 653.049 "iterations=8"
0.852744 651.733 "iterations=7"
0.913963 603.965 "iterations=7"
1.15741 65.5446 "iterations=1"
1.59854 44.9605 "passes=1 iterations=2"
2.2398 23.2402 "passes=2 iterations=2"
2.86257 22.5342 "passes=3 iterations=2"
3.52377 21.7296 "passes=4 iterations=2"
4.1946 19.7798 "passes=4 iterations=4"
5.24007 11.8305 "passes=3 substeps=2"
9.98607 7.04571 "passes=3 substeps=4"
22.3543 4.81452 "passes=3 substeps=8"
111.698 2.52325 "substeps=740"
151.545 2.42118 "substeps=1138"
END
$curve0 << END
0.465065 713.315 "iterations=1"
0.591411 686.147 "iterations=3"
0.852744 651.733 "iterations=7"
1.23069 628.84 "iterations=15"
2.048 611.071 "iterations=31"
3.60433 605.588 "iterations=63"
7.21014 613.437 "iterations=127"
14.4253 595.636 "iterations=255"
END
$curve1 << END
0.502672 700.793 "iterations=2"
0.833343 653.049 "iterations=8"
1.27275 629.975 "iterations=16"
4.04322 604.094 "iterations=64"
END
$curve2 << END
0.59482 709.919 "iterations=1"
0.913963 603.965 "iterations=7"
2.32295 525.353 "iterations=31"
7.78924 487.794 "iterations=127"
END
$curve3 << END
1.76172 612.445 "iterations=7 substeps=2"
3.50398 594.106 "iterations=7 substeps=4"
6.21934 498.972 "iterations=7 substeps=8"
12.4877 355.917 "iterations=7 substeps=16"
END
$curve4 << END
0.649131 701.376 "iterations=4"
0.908507 673.954 "iterations=8"
1.44532 624.693 "iterations=16"
2.35863 541.137 "iterations=32"
4.0759 392.38 "iterations=64"
7.77975 206.116 "iterations=128"
END
$curve5 << END
0.755605 671.959 "iterations=4"
1.06146 648.074 "iterations=8"
1.90618 601.56 "iterations=16"
3.51245 533.509 "iterations=32"
6.6772 363.994 "iterations=64"
13.1103 160.454 "iterations=128"
END
$curve6 << END
1.43931 116.058 "iterations=1"
2.00019 86.1478 "iterations=2"
2.86988 74.3993 "iterations=3"
3.2641 80.1204 "iterations=4"
4.32998 76.7565 "iterations=6"
5.82313 66.4352 "iterations=8"
9.01844 69.0015 "iterations=12"
10.7708 66.067 "iterations=16"
END
$curve7 << END
1.15741 65.5446 "iterations=1"
1.60397 51.004 "iterations=2"
2.54307 50.3124 "iterations=4"
4.21056 69.3682 "iterations=8"
END
$curve8 << END
1.8752 59.5847 "passes=2 iterations=1"
2.46583 35.624 "passes=2 iterations=2"
2.60058 41.9513 "passes=3 iterations=1"
2.94979 38.4084 "passes=3 iterations=2"
3.19455 41.2886 "passes=2 iterations=4"
3.48598 38.382 "passes=4 iterations=2"
3.48656 45.1071 "passes=4 iterations=1"
3.93078 39.017 "passes=3 iterations=4"
4.15695 39.6059 "passes=2 iterations=6"
4.22556 38.6948 "passes=4 iterations=4"
4.65287 41.681 "passes=6 iterations=1"
4.781 38.2658 "passes=3 iterations=6"
4.87463 38.5379 "passes=6 iterations=2"
5.84126 39.3816 "passes=8 iterations=1"
6.02405 38.6136 "passes=8 iterations=2"
END
$curve9 << END
2.24711 36.1821 "passes=1 substeps=2"
4.64244 25.7075 "passes=1 substeps=4"
8.87883 16.2623 "passes=1 substeps=8"
18.1652 11.1991 "passes=1 substeps=16"
END
$curve10 << END
1.59854 44.9605 "passes=1 iterations=2"
2.2398 23.2402 "passes=2 iterations=2"
2.86257 22.5342 "passes=3 iterations=2"
3.52377 21.7296 "passes=4 iterations=2"
4.1946 19.7798 "passes=4 iterations=4"
5.58354 19.1883 "passes=6 iterations=4"
END
$curve11 << END
5.24007 11.8305 "passes=3 substeps=2"
9.98607 7.04571 "passes=3 substeps=4"
22.3543 4.81452 "passes=3 substeps=8"
END
$curve12 << END
0.414006 930.046 "substeps=1"
0.768458 887.683 "substeps=2"
1.42494 802.674 "substeps=4"
2.88871 633.9 "substeps=8"
5.79232 388.454 "substeps=16"
11.2353 175.378 "substeps=32"
18.7997 80.7652 "substeps=64"
END
$curve13 << END
1.19808 896.345 "iterations=4"
4.34258 801.377 "iterations=16"
17.1888 594.737 "iterations=64"
END
$curve14 << END
4.47796 748.717 "iterations=16"
16.2871 506.883 "iterations=64"
END
$curve15 << END
6.16308 312.015 "iterations=1 substeps=16"
24.5395 43.3725 "iterations=1 substeps=64"
END
$curve16 << END
111.698 2.52325 "substeps=740"
151.545 2.42118 "substeps=1138"
312.563 3.52994 "substeps=2276"
END
$curve17 << END
144.763 3.66304 "substeps=740"
539.605 3.2566 "substeps=2276"
END
$default << END
2.94979 38.4084 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-128-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  37.4936 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  19.0158 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-128-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  37.4936 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  19.0158 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
