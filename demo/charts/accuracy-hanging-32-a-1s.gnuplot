set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0226744:35.3981]
set yrange [1.05958:3388.72]
set title 'Sheet hung by two corners, 32 × 32 particles: distance from converged backward Euler after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=72; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.032392 2117.95 "substeps=1"
0.045374 1581.52 "iterations=1"
0.053935 1180.65 "iterations=1"
0.054425 800.115 "iterations=4"
0.054586 492.032 "substeps=2"
0.088546 152.622 "iterations=1"
0.113706 114.029 "substeps=4"
0.115549 31.9859 "iterations=2"
0.139997 21.0472 "passes=2 iterations=1"
0.189202 13.8856 "passes=3 iterations=1"
0.218908 4.59078 "passes=3 iterations=2"
0.304475 4.44212 "passes=4 iterations=1"
0.318402 2.21339 "passes=4 iterations=2"
0.387042 1.96145 "passes=4 iterations=4"
0.526885 1.51369 "passes=8 iterations=2"
END
$curve0 << END
0.053935 1180.65 "iterations=1"
0.065594 1078.82 "iterations=3"
0.068582 945.35 "iterations=7"
0.148075 768.482 "iterations=15"
0.255229 667.657 "iterations=31"
0.476511 554.511 "iterations=63"
0.748145 447.554 "iterations=127"
1.61137 341.574 "iterations=255"
END
$curve1 << END
0.087925 790.366 "iterations=8"
0.140337 618.674 "iterations=16"
0.437609 435.826 "iterations=64"
END
$curve2 << END
0.058508 821.686 "iterations=1"
0.09767 581.772 "iterations=7"
0.279268 423.664 "iterations=31"
0.814601 286.436 "iterations=127"
END
$curve3 << END
0.134895 592.798 "iterations=7 substeps=2"
0.257363 181.928 "iterations=7 substeps=4"
0.508911 80.9256 "iterations=7 substeps=8"
1.04491 146.877 "iterations=7 substeps=16"
END
$curve4 << END
0.054425 800.115 "iterations=4"
0.074594 628.348 "iterations=8"
0.114809 374.461 "iterations=16"
0.200673 110.903 "iterations=32"
0.357176 34.4168 "iterations=64"
0.705384 99.0015 "iterations=128"
END
$curve5 << END
0.061933 870.72 "iterations=4"
0.094926 638.481 "iterations=8"
0.160985 341.449 "iterations=16"
0.293493 149.538 "iterations=32"
0.627766 100.695 "iterations=64"
1.1669 103.545 "iterations=128"
END
$curve6 << END
0.113393 152.759 "iterations=1"
0.191 34.0259 "iterations=2"
0.211127 17.1071 "iterations=3"
0.2575 7.6217 "iterations=4"
0.319452 4.78607 "iterations=6"
0.417734 4.482 "iterations=8"
0.626524 4.30834 "iterations=12"
0.737629 4.88254 "iterations=16"
END
$curve7 << END
0.088546 152.622 "iterations=1"
0.115549 31.9859 "iterations=2"
0.176874 29.011 "iterations=4"
0.310996 29.6688 "iterations=8"
END
$curve8 << END
0.139997 21.0472 "passes=2 iterations=1"
0.169782 25.5697 "passes=2 iterations=2"
0.189202 13.8856 "passes=3 iterations=1"
0.218908 4.59078 "passes=3 iterations=2"
0.264266 5.75013 "passes=2 iterations=4"
0.304475 4.44212 "passes=4 iterations=1"
0.318402 2.21339 "passes=4 iterations=2"
0.326172 3.98385 "passes=3 iterations=4"
0.387042 1.96145 "passes=4 iterations=4"
0.411197 6.01961 "passes=2 iterations=6"
0.414034 3.57887 "passes=3 iterations=6"
0.523151 2.55667 "passes=6 iterations=1"
0.526885 1.51369 "passes=8 iterations=2"
0.55128 2.06399 "passes=6 iterations=2"
0.676632 2.42188 "passes=8 iterations=1"
END
$curve9 << END
0.201197 24.9665 "passes=1 substeps=2"
0.441667 78.9852 "passes=1 substeps=4"
0.858253 124.408 "passes=1 substeps=8"
1.44036 144.604 "passes=1 substeps=16"
END
$curve10 << END
0.11896 171.366 "passes=1 iterations=2"
0.171215 153.526 "passes=2 iterations=2"
0.235335 161.026 "passes=3 iterations=2"
0.30994 172.136 "passes=4 iterations=2"
0.382104 172.959 "passes=4 iterations=4"
0.491445 172.733 "passes=6 iterations=4"
END
$curve11 << END
0.474829 167.178 "passes=3 substeps=2"
0.938823 170.862 "passes=3 substeps=4"
1.87742 175.046 "passes=3 substeps=8"
END
$curve12 << END
0.032392 2117.95 "substeps=1"
0.054586 492.032 "substeps=2"
0.113706 114.029 "substeps=4"
0.268961 141.109 "substeps=8"
0.622568 162.961 "substeps=16"
1.2612 171.39 "substeps=32"
2.52102 171.265 "substeps=64"
END
$curve13 << END
0.134344 460.095 "iterations=4"
0.472377 83.0037 "iterations=16"
1.84227 25.8848 "iterations=64"
END
$curve14 << END
0.045374 1581.52 "iterations=1"
0.12685 279.234 "iterations=4"
0.446692 58.1302 "iterations=16"
1.76717 42.2732 "iterations=64"
END
$curve15 << END
0.163875 105.485 "iterations=1 substeps=4"
0.632627 173.224 "iterations=1 substeps=16"
2.53628 172.633 "iterations=1 substeps=64"
END
$curve16 << END
1.31376 176.117 "substeps=72"
2.02195 175.159 "substeps=111"
3.00762 176.652 "substeps=222"
END
$curve17 << END
3.46255 180.963 "substeps=222"
END
$curve18 << END
22.1238 103.484 "one factorisation a step"
END
$default << END
0.218908 4.59078 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-32-a-1s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  103.484 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
set output 'accuracy-hanging-32-a-1s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  103.484 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
