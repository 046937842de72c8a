set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0226744:35.3981]
set yrange [0.141142:1243.8]
set title 'Sheet hung by two corners, 32 × 32 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=72; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.032392 777.377 "substeps=1"
0.045374 741.446 "iterations=1"
0.053935 612.872 "iterations=1"
0.054425 602.528 "iterations=4"
0.054586 563.537 "substeps=2"
0.074594 534.295 "iterations=8"
0.088546 65.1768 "iterations=1"
0.115549 57.6778 "iterations=2"
0.11896 41.7782 "passes=1 iterations=2"
0.169782 40.514 "passes=2 iterations=2"
0.171215 23.6517 "passes=2 iterations=2"
0.30994 20.4118 "passes=4 iterations=2"
0.474829 10.5516 "passes=3 substeps=2"
0.938823 4.33158 "passes=3 substeps=4"
1.31376 0.361271 "substeps=72"
2.02195 0.282006 "substeps=111"
3.00762 0.201632 "substeps=222"
END
$curve0 << END
0.053935 612.872 "iterations=1"
0.065594 616.351 "iterations=3"
0.068582 620.985 "iterations=7"
0.148075 599.905 "iterations=15"
0.255229 554.216 "iterations=31"
0.476511 486.162 "iterations=63"
0.748145 402.83 "iterations=127"
1.61137 314.556 "iterations=255"
END
$curve1 << END
0.087925 549.037 "iterations=8"
0.140337 537.242 "iterations=16"
0.437609 464.781 "iterations=64"
END
$curve2 << END
0.058508 570.255 "iterations=1"
0.09767 480.432 "iterations=7"
0.279268 399.279 "iterations=31"
0.814601 295.895 "iterations=127"
END
$curve3 << END
0.134895 525.916 "iterations=7 substeps=2"
0.257363 354.548 "iterations=7 substeps=4"
0.508911 221.605 "iterations=7 substeps=8"
1.04491 89.8585 "iterations=7 substeps=16"
END
$curve4 << END
0.054425 602.528 "iterations=4"
0.074594 534.295 "iterations=8"
0.114809 381.374 "iterations=16"
0.200673 194.183 "iterations=32"
0.357176 83.56 "iterations=64"
0.705384 86.2309 "iterations=128"
END
$curve5 << END
0.061933 617.929 "iterations=4"
0.094926 528.306 "iterations=8"
0.160985 354.247 "iterations=16"
0.293493 150.405 "iterations=32"
0.627766 89.6398 "iterations=64"
1.1669 88.7289 "iterations=128"
END
$curve6 << END
0.113393 65.1904 "iterations=1"
0.191 63.336 "iterations=2"
0.211127 49.0876 "iterations=3"
0.2575 47.659 "iterations=4"
0.319452 45.2939 "iterations=6"
0.417734 44.4591 "iterations=8"
0.626524 43.8726 "iterations=12"
0.737629 43.599 "iterations=16"
END
$curve7 << END
0.088546 65.1768 "iterations=1"
0.115549 57.6778 "iterations=2"
0.176874 54.5944 "iterations=4"
0.310996 54.4033 "iterations=8"
END
$curve8 << END
0.139997 67.1983 "passes=2 iterations=1"
0.169782 40.514 "passes=2 iterations=2"
0.189202 40.8602 "passes=3 iterations=1"
0.218908 44.241 "passes=3 iterations=2"
0.264266 44.6936 "passes=2 iterations=4"
0.304475 50.2513 "passes=4 iterations=1"
0.318402 41.5008 "passes=4 iterations=2"
0.326172 42.8285 "passes=3 iterations=4"
0.387042 42.3292 "passes=4 iterations=4"
0.411197 44.8745 "passes=2 iterations=6"
0.414034 42.6002 "passes=3 iterations=6"
0.523151 45.1648 "passes=6 iterations=1"
0.526885 42.0815 "passes=8 iterations=2"
0.55128 41.8897 "passes=6 iterations=2"
0.676632 43.484 "passes=8 iterations=1"
END
$curve9 << END
0.201197 39.1704 "passes=1 substeps=2"
0.441667 28.9888 "passes=1 substeps=4"
0.858253 19.306 "passes=1 substeps=8"
1.44036 12.5797 "passes=1 substeps=16"
END
$curve10 << END
0.11896 41.7782 "passes=1 iterations=2"
0.171215 23.6517 "passes=2 iterations=2"
0.235335 25.513 "passes=3 iterations=2"
0.30994 20.4118 "passes=4 iterations=2"
0.382104 21.7771 "passes=4 iterations=4"
0.491445 21.369 "passes=6 iterations=4"
END
$curve11 << END
0.474829 10.5516 "passes=3 substeps=2"
0.938823 4.33158 "passes=3 substeps=4"
1.87742 1.74723 "passes=3 substeps=8"
END
$curve12 << END
0.032392 777.377 "substeps=1"
0.054586 563.537 "substeps=2"
0.113706 298.505 "substeps=4"
0.268961 124.427 "substeps=8"
0.622568 64.7324 "substeps=16"
1.2612 27.7486 "substeps=32"
2.52102 9.99953 "substeps=64"
END
$curve13 << END
0.134344 540.845 "iterations=4"
0.472377 262.953 "iterations=16"
1.84227 116.886 "iterations=64"
END
$curve14 << END
0.045374 741.446 "iterations=1"
0.12685 473.497 "iterations=4"
0.446692 197.072 "iterations=16"
1.76717 73.662 "iterations=64"
END
$curve15 << END
0.163875 242.164 "iterations=1 substeps=4"
0.632627 29.0997 "iterations=1 substeps=16"
2.53628 5.10418 "iterations=1 substeps=64"
END
$curve16 << END
1.31376 0.361271 "substeps=72"
2.02195 0.282006 "substeps=111"
3.00762 0.201632 "substeps=222"
END
$curve17 << END
3.46255 3.16957 "substeps=222"
END
$curve18 << END
22.1238 88.7217 "one factorisation a step"
END
$default << END
0.218908 44.241 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-32-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  42.081 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  21.3079 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
set output 'accuracy-hanging-32-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  42.081 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  21.3079 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
