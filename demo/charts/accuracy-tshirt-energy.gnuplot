set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0793037:351.134]
set yrange [0.000721441:4.02733]
set title 'T-shirt hung by its neck, 3546 particles: energy left above the converged step' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'energy gap over that of the inertial start'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 5
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 2923; weft_study accuracy, then weft_study plot' at screen 0.012, screen 0.022 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.113291 2.51708 "substeps=1"
0.125949 0.314565 "iterations=1"
0.152594 0.180198 "iterations=2"
0.191915 0.139285 "iterations=4"
0.233537 0.136161 "iterations=4"
0.270642 0.111767 "iterations=8"
0.321035 0.0231719 "iterations=1"
0.491038 0.00633104 "passes=2 iterations=1"
0.601608 0.00463236 "passes=2 iterations=2"
0.726541 0.00350032 "passes=3 iterations=1"
0.745062 0.00264844 "passes=3 iterations=2"
0.89962 0.00261395 "passes=4 iterations=1"
1.06195 0.00192548 "passes=4 iterations=2"
1.11333 0.00189477 "passes=3 iterations=4"
1.35027 0.00136593 "passes=4 iterations=4"
1.43671 0.00127425 "passes=6 iterations=2"
1.709 0.00103063 "passes=8 iterations=2"
END
$curve0 << END
0.125949 0.314565 "iterations=1"
0.174391 0.263431 "iterations=3"
0.252714 0.203547 "iterations=7"
0.415928 0.148721 "iterations=15"
0.729599 0.112865 "iterations=31"
1.40783 0.0953047 "iterations=63"
2.75852 0.0844375 "iterations=127"
5.41597 0.0735123 "iterations=255"
END
$curve1 << END
0.152594 0.180198 "iterations=2"
0.270642 0.111767 "iterations=8"
0.430389 0.100846 "iterations=16"
1.19549 0.0935701 "iterations=64"
END
$curve2 << END
0.14421 0.430898 "iterations=1"
0.277542 0.319515 "iterations=7"
0.708593 0.227923 "iterations=31"
2.71029 0.197027 "iterations=127"
END
$curve3 << END
0.474937 0.0613378 "iterations=7 substeps=2"
0.894672 0.00666047 "iterations=7 substeps=4"
1.88946 0.00301036 "iterations=7 substeps=8"
3.74455 0.00182602 "iterations=7 substeps=16"
END
$curve4 << END
0.191915 0.139285 "iterations=4"
0.274643 0.118525 "iterations=8"
0.438625 0.0770625 "iterations=16"
0.660742 0.0601063 "iterations=32"
1.44798 0.0423012 "iterations=64"
2.58303 0.0254688 "iterations=128"
END
$curve5 << END
0.233537 0.136161 "iterations=4"
0.381897 0.10274 "iterations=8"
0.721393 0.0842974 "iterations=16"
1.29758 0.0561619 "iterations=32"
2.50704 0.0337657 "iterations=64"
4.65851 0.024808 "iterations=128"
END
$curve6 << END
0.412286 0.0231719 "iterations=1"
0.597027 0.0109803 "iterations=2"
0.855724 0.00943409 "iterations=3"
0.970914 0.00749905 "iterations=4"
1.40921 0.00633945 "iterations=6"
1.89388 0.00498524 "iterations=8"
2.34817 0.0026819 "iterations=12"
3.2817 0.00161644 "iterations=16"
END
$curve7 << END
0.321035 0.0231719 "iterations=1"
0.497153 0.012585 "iterations=2"
0.695462 0.0103297 "iterations=4"
1.09536 0.00978545 "iterations=8"
END
$curve8 << END
0.491038 0.00633104 "passes=2 iterations=1"
0.601608 0.00463236 "passes=2 iterations=2"
0.726541 0.00350032 "passes=3 iterations=1"
0.745062 0.00264844 "passes=3 iterations=2"
0.89962 0.00261395 "passes=4 iterations=1"
0.924697 0.00347528 "passes=2 iterations=4"
1.06195 0.00192548 "passes=4 iterations=2"
1.11333 0.00189477 "passes=3 iterations=4"
1.2172 0.00310725 "passes=2 iterations=6"
1.35027 0.00136593 "passes=4 iterations=4"
1.35485 0.00186943 "passes=6 iterations=1"
1.4084 0.00156037 "passes=3 iterations=6"
1.43671 0.00127425 "passes=6 iterations=2"
1.55434 0.00145905 "passes=8 iterations=1"
1.709 0.00103063 "passes=8 iterations=2"
END
$curve9 << END
0.607535 0.00816451 "passes=1 substeps=2"
1.16467 0.0033061 "passes=1 substeps=4"
2.32605 0.00172099 "passes=1 substeps=8"
4.70879 0.00111872 "passes=1 substeps=16"
END
$curve10 << END
0.113291 2.51708 "substeps=1"
0.203121 2.42101 "substeps=2"
0.392712 2.22762 "substeps=4"
0.753485 1.57012 "substeps=8"
1.51645 0.835779 "substeps=16"
2.9834 0.303153 "substeps=32"
6.32109 0.0826515 "substeps=64"
END
$curve11 << END
0.34145 2.17868 "iterations=4"
1.53219 1.94379 "iterations=16"
4.21857 1.39337 "iterations=64"
END
$curve12 << END
0.222708 1.91493 "iterations=1"
0.704866 1.44745 "iterations=4"
2.71466 1.14809 "iterations=16"
11.4883 0.745793 "iterations=64"
END
$curve13 << END
0.817958 1.2214 "iterations=1 substeps=4"
3.62119 0.446008 "iterations=1 substeps=16"
13.4996 0.0458958 "iterations=1 substeps=64"
END
$curve14 << END
29.9501 0.00106065 "substeps=641"
43.7698 0.00105969 "substeps=985"
87.6725 0.00105758 "substeps=1970"
END
$curve15 << END
40.6327 0.00106271 "substeps=641"
125.118 0.00105861 "substeps=1970"
END
$curve16 << END
219.459 0.0229325 "one factorisation a step"
END
$default << END
0.745062 0.00264844 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-tshirt-energy.svg'
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
set output 'accuracy-tshirt-energy.png'
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
