set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0926023:421.325]
set yrange [0.270859:4.67134]
set ytics (0.5, 1, 2)
set title 'Dress hung by its neck, 4589 particles: distance from the converged step' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles after one step [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 5
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 8572a2e; κ = 1504; weft_study accuracy, then weft_study plot' at screen 0.012, screen 0.022 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.132289 2.91959 "substeps=1"
0.141893 1.21598 "iterations=1"
0.196896 1.20724 "iterations=3"
0.233799 1.17596 "iterations=4"
0.289249 0.880653 "iterations=1"
0.404086 0.814565 "iterations=2"
0.586362 0.745856 "passes=2 iterations=2"
0.619482 0.717102 "iterations=4"
0.753214 0.662743 "passes=3 iterations=2"
0.82644 0.589715 "passes=2 iterations=4"
0.929617 0.579199 "passes=4 iterations=2"
1.06301 0.473746 "passes=2 iterations=6"
1.12813 0.424524 "passes=4 iterations=4"
1.23127 0.389976 "passes=3 iterations=6"
1.59499 0.386941 "passes=8 iterations=2"
END
$curve0 << END
0.141893 1.21598 "iterations=1"
0.196896 1.20724 "iterations=3"
0.28152 1.18747 "iterations=7"
0.500183 1.15664 "iterations=15"
0.940942 1.11274 "iterations=31"
1.72538 1.05681 "iterations=63"
3.43085 0.993486 "iterations=127"
6.39036 0.930157 "iterations=255"
END
$curve1 << END
0.161659 1.27015 "iterations=2"
0.318181 1.1896 "iterations=8"
0.475929 1.15001 "iterations=16"
1.75185 1.05481 "iterations=64"
END
$curve2 << END
0.149006 1.25687 "iterations=1"
0.308884 1.22994 "iterations=7"
0.839488 1.15734 "iterations=31"
3.34705 1.04102 "iterations=127"
END
$curve3 << END
0.517098 1.08677 "iterations=7 substeps=2"
1.09758 1.01451 "iterations=7 substeps=4"
2.21648 0.880475 "iterations=7 substeps=8"
4.32204 0.697674 "iterations=7 substeps=16"
END
$curve4 << END
0.233799 1.17596 "iterations=4"
0.331154 1.1116 "iterations=8"
0.523045 0.990814 "iterations=16"
0.937693 0.891945 "iterations=32"
1.72742 0.911255 "iterations=64"
3.4434 0.933317 "iterations=128"
END
$curve5 << END
0.295388 1.19836 "iterations=4"
0.472611 1.12582 "iterations=8"
0.840285 1.00044 "iterations=16"
1.40242 0.903913 "iterations=32"
2.72744 0.890858 "iterations=64"
5.33405 0.909496 "iterations=128"
END
$curve6 << END
0.393447 0.880653 "iterations=1"
0.584592 0.837261 "iterations=2"
0.924006 0.829177 "iterations=3"
1.17069 0.810945 "iterations=4"
1.67323 0.756006 "iterations=6"
2.10628 0.725974 "iterations=8"
2.63534 0.676785 "iterations=12"
3.4395 0.618789 "iterations=16"
END
$curve7 << END
0.289249 0.880653 "iterations=1"
0.404086 0.814565 "iterations=2"
0.619482 0.717102 "iterations=4"
1.09147 0.637681 "iterations=8"
END
$curve8 << END
0.468543 0.817381 "passes=2 iterations=1"
0.586362 0.745856 "passes=2 iterations=2"
0.673047 0.749594 "passes=3 iterations=1"
0.753214 0.662743 "passes=3 iterations=2"
0.82644 0.589715 "passes=2 iterations=4"
0.898871 0.696113 "passes=4 iterations=1"
0.929617 0.579199 "passes=4 iterations=2"
1.06301 0.473746 "passes=2 iterations=6"
1.12813 0.424524 "passes=4 iterations=4"
1.20038 0.492581 "passes=3 iterations=4"
1.23127 0.389976 "passes=3 iterations=6"
1.34811 0.613292 "passes=6 iterations=1"
1.48793 0.458367 "passes=6 iterations=2"
1.59499 0.386941 "passes=8 iterations=2"
1.70153 0.549936 "passes=8 iterations=1"
END
$curve9 << END
0.653642 0.818958 "passes=1 substeps=2"
1.25719 0.722531 "passes=1 substeps=4"
2.36402 0.575384 "passes=1 substeps=8"
4.54829 0.500998 "passes=1 substeps=16"
END
$curve10 << END
0.132289 2.91959 "substeps=1"
0.249947 2.3422 "substeps=2"
0.479451 2.06389 "substeps=4"
0.984399 1.89585 "substeps=8"
1.89276 1.70726 "substeps=16"
3.76356 1.37305 "substeps=32"
7.58765 0.914181 "substeps=64"
END
$curve11 << END
0.413114 2.8628 "iterations=4"
1.43704 2.78326 "iterations=16"
5.54176 2.61208 "iterations=64"
END
$curve12 << END
0.223833 2.87253 "iterations=1"
0.724123 2.78334 "iterations=4"
2.6884 2.60965 "iterations=16"
10.6584 2.12403 "iterations=64"
END
$curve13 << END
0.868868 1.95718 "iterations=1 substeps=4"
3.46175 1.4213 "iterations=1 substeps=16"
13.1281 0.70068 "iterations=1 substeps=64"
END
$curve14 << END
11.2515 0.500433 "substeps=207"
17.2608 0.500825 "substeps=318"
34.8296 0.500863 "substeps=635"
END
$curve15 << END
15.3887 0.499858 "substeps=207"
47.0981 0.500856 "substeps=635"
END
$curve16 << END
263.328 0.911581 "one factorisation a step"
END
$default << END
0.753214 0.662743 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-dress-step.svg'
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
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-dress-step.png'
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
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
