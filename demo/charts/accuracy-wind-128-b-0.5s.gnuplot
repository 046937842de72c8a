set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.284979:1010.47]
set yrange [1.88317:961.523]
set title 'Hung sheet in wind, 128 × 128 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1; Fibres and sets iterations=4' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.407113 540.716 "substeps=1"
0.502324 150.511 "iterations=2"
0.624457 139.491 "iterations=3"
0.71098 131.426 "iterations=4"
0.717732 127.505 "iterations=4"
0.955551 99.8322 "iterations=8"
0.960838 92.3313 "iterations=7"
1.20871 87.5767 "iterations=16"
1.33703 26.1161 "iterations=1"
1.81937 23.2776 "iterations=2"
2.04467 22.5862 "iterations=4"
2.15012 20.6054 "passes=1 substeps=2"
2.44172 20.4832 "passes=3 iterations=2"
3.61496 19.442 "passes=4 iterations=2"
3.71596 19.2952 "passes=3 iterations=4"
4.02831 14.6194 "passes=1 substeps=4"
5.26816 14.0737 "passes=3 substeps=2"
8.97906 11.3945 "passes=1 substeps=8"
10.7569 9.85988 "passes=3 substeps=4"
16.0231 8.9546 "passes=1 substeps=16"
20.014 5.97233 "passes=3 substeps=8"
145.911 3.07636 "substeps=740"
288.356 2.69025 "substeps=1138"
END
$curve0 << END
0.532151 159.788 "iterations=1"
0.624457 139.491 "iterations=3"
0.851288 129.773 "iterations=7"
1.11066 115.9 "iterations=15"
1.8616 97.4312 "iterations=31"
3.34246 88.3728 "iterations=63"
6.74611 88.351 "iterations=127"
12.6151 82.0928 "iterations=255"
END
$curve1 << END
0.502324 150.511 "iterations=2"
0.858906 144.014 "iterations=8"
1.34294 140.418 "iterations=16"
3.37405 88.1335 "iterations=64"
END
$curve2 << END
0.607507 163.885 "iterations=1"
0.960838 92.3313 "iterations=7"
2.01315 63.492 "iterations=31"
7.33546 52.9777 "iterations=127"
END
$curve3 << END
1.43514 104.134 "iterations=7 substeps=2"
2.86863 86.6197 "iterations=7 substeps=4"
5.64684 69.3135 "iterations=7 substeps=8"
11.4826 51.0045 "iterations=7 substeps=16"
END
$curve4 << END
0.71098 131.426 "iterations=4"
0.955551 99.8322 "iterations=8"
1.20871 87.5767 "iterations=16"
2.03349 71.4338 "iterations=32"
3.95041 47.745 "iterations=64"
7.72995 29.2591 "iterations=128"
END
$curve5 << END
0.717732 127.505 "iterations=4"
1.21127 92.1748 "iterations=8"
1.98097 89.7517 "iterations=16"
3.51959 65.1453 "iterations=32"
8.0769 42.7341 "iterations=64"
13.5392 27.8565 "iterations=128"
END
$curve6 << END
1.59275 26.1172 "iterations=1"
2.47558 23.8301 "iterations=2"
2.69978 22.7642 "iterations=3"
3.51264 23.6695 "iterations=4"
5.24082 21.8313 "iterations=6"
6.55611 24.118 "iterations=8"
8.80168 22.5133 "iterations=12"
9.76998 22.8982 "iterations=16"
END
$curve7 << END
1.33703 26.1161 "iterations=1"
1.81937 23.2776 "iterations=2"
2.04467 22.5862 "iterations=4"
3.3621 26.9775 "iterations=8"
END
$curve8 << END
2.05344 24.5695 "passes=2 iterations=1"
2.31201 22.3653 "passes=2 iterations=2"
2.43245 22.4983 "passes=3 iterations=1"
2.44172 20.4832 "passes=3 iterations=2"
3.08003 21.7643 "passes=4 iterations=1"
3.2871 20.6136 "passes=2 iterations=6"
3.51468 21.0972 "passes=2 iterations=4"
3.61496 19.442 "passes=4 iterations=2"
3.67362 19.7375 "passes=6 iterations=1"
3.71596 19.2952 "passes=3 iterations=4"
4.33688 18.9688 "passes=3 iterations=6"
4.36094 18.5494 "passes=4 iterations=4"
4.58679 18.0953 "passes=6 iterations=2"
4.84819 18.5168 "passes=8 iterations=1"
5.08992 17.6268 "passes=8 iterations=2"
END
$curve9 << END
2.15012 20.6054 "passes=1 substeps=2"
4.02831 14.6194 "passes=1 substeps=4"
8.97906 11.3945 "passes=1 substeps=8"
16.0231 8.9546 "passes=1 substeps=16"
END
$curve10 << END
1.69738 28.3247 "passes=1 iterations=2"
2.2008 23.3135 "passes=2 iterations=2"
2.97054 22.7709 "passes=3 iterations=2"
3.25862 21.4849 "passes=4 iterations=2"
3.9926 21.3459 "passes=4 iterations=4"
5.46056 21.1595 "passes=6 iterations=4"
END
$curve11 << END
5.26816 14.0737 "passes=3 substeps=2"
10.7569 9.85988 "passes=3 substeps=4"
20.014 5.97233 "passes=3 substeps=8"
END
$curve12 << END
0.407113 540.716 "substeps=1"
0.656025 600.952 "substeps=2"
1.38434 594.803 "substeps=4"
2.52321 485.544 "substeps=8"
4.98351 268.931 "substeps=16"
9.7285 92.8757 "substeps=32"
21.4179 46.4005 "substeps=64"
END
$curve13 << END
0.864701 525.113 "iterations=4"
2.92268 478.411 "iterations=16"
14.1801 352.787 "iterations=64"
END
$curve14 << END
4.01109 447.525 "iterations=16"
15.3425 287.89 "iterations=64"
END
$curve15 << END
6.50447 203.909 "iterations=1 substeps=16"
27.953 39.2251 "iterations=1 substeps=64"
END
$curve16 << END
145.911 3.07636 "substeps=740"
288.356 2.69025 "substeps=1138"
508.719 3.24672 "substeps=2276"
END
$curve17 << END
190.869 5.61633 "substeps=740"
631.541 2.93445 "substeps=2276"
END
$default << END
2.44172 20.4832 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-128-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  16.7549 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.7376 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
set output 'accuracy-wind-128-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  16.7549 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.7376 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
