set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0133:20.624]
set yrange [0.117954:1329]
set title 'Sheet hung by two corners, 32 × 32 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=47; Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.019 633.963 "iterations=1"
0.022 628.384 "iterations=2"
0.024 597.393 "iterations=3"
0.033 560.217 "iterations=1"
0.039 468.506 "iterations=8"
0.048 449.06 "iterations=7"
0.062 363.557 "iterations=16"
0.095 39.9009 "passes=2"
0.096 39.5449 "passes=1"
0.107 22.6954 "passes=1"
0.128 22.1512 "passes=2"
0.13 20.344 "passes=3"
0.241 11.6221 "passes=1 substeps=2"
0.253 10.6309 "passes=3 substeps=2"
0.363 0.50034 "substeps=47"
0.549 0.333635 "substeps=71"
1.101 0.168506 "substeps=142"
END
$curve0 << END
0.019 633.963 "iterations=1"
0.024 597.393 "iterations=3"
0.036 607.065 "iterations=7"
0.057 584.116 "iterations=15"
0.1 536.605 "iterations=31"
0.185 467.102 "iterations=63"
0.357 383.293 "iterations=127"
0.707 292.772 "iterations=255"
END
$curve1 << END
0.022 628.384 "iterations=2"
0.039 468.506 "iterations=8"
0.061 474.033 "iterations=16"
0.188 496.523 "iterations=64"
END
$curve2 << END
0.033 560.217 "iterations=1"
0.048 449.06 "iterations=7"
0.114 374.257 "iterations=31"
0.37 265.629 "iterations=127"
END
$curve3 << END
0.067 511.548 "iterations=7 substeps=2"
0.128 343.918 "iterations=7 substeps=4"
0.251 202.576 "iterations=7 substeps=8"
0.475 70.1238 "iterations=7 substeps=16"
END
$curve4 << END
0.028 603.861 "iterations=4"
0.04 494.345 "iterations=8"
0.062 363.557 "iterations=16"
0.106 158.929 "iterations=32"
0.196 79.2013 "iterations=64"
0.376 76.7062 "iterations=128"
END
$curve5 << END
0.037 599.995 "iterations=4"
0.059 483.475 "iterations=8"
0.103 344.73 "iterations=16"
0.191 117.428 "iterations=32"
0.368 81.371 "iterations=64"
0.722 79.5327 "iterations=128"
END
$curve6 << END
0.095 39.9009 "passes=2"
0.096 39.5449 "passes=1"
0.127 38.708 "passes=3"
0.159 38.3858 "passes=4"
0.223 38.326 "passes=6"
0.287 38.3347 "passes=8"
0.418 38.4076 "passes=12"
0.611 38.4399 "passes=18"
END
$curve7 << END
0.184 26.2281 "passes=1 substeps=2"
0.367 18.3118 "passes=1 substeps=4"
0.724 12.6172 "passes=1 substeps=8"
1.464 8.33546 "passes=1 substeps=16"
END
$curve8 << END
0.107 22.6954 "passes=1"
0.128 22.1512 "passes=2"
0.13 20.344 "passes=3"
0.161 20.879 "passes=4"
0.235 20.512 "passes=6"
0.295 20.5511 "passes=8"
0.423 20.6532 "passes=12"
END
$curve9 << END
0.241 11.6221 "passes=1 substeps=2"
0.253 10.6309 "passes=3 substeps=2"
0.436 4.77286 "passes=1 substeps=4"
0.503 4.53229 "passes=3 substeps=4"
0.79 1.48699 "passes=1 substeps=8"
1.022 1.29027 "passes=3 substeps=8"
END
$curve10 << END
0.047 830.622 "substeps=1"
0.082 654.729 "substeps=2"
0.16 371.402 "substeps=4"
0.316 131.982 "substeps=8"
0.629 56.1214 "substeps=16"
1.246 22.6708 "substeps=32"
2.54 8.48438 "substeps=64"
END
$curve11 << END
0.073 644.359 "iterations=4"
0.184 338.449 "iterations=16"
0.632 118.725 "iterations=64"
END
$curve12 << END
0.086 554.92 "iterations=4"
0.231 237.856 "iterations=16"
0.837 69.792 "iterations=64"
END
$curve13 << END
0.181 291.026 "iterations=1 substeps=4"
0.706 26.7179 "iterations=1 substeps=16"
2.814 5.06628 "iterations=1 substeps=64"
END
$curve14 << END
0.363 0.50034 "substeps=47"
0.549 0.333635 "substeps=71"
1.101 0.168506 "substeps=142"
END
$curve15 << END
1.673 5.80992 "substeps=142"
END
$curve16 << END
12.89 79.5353 "one factorisation a step"
END
$default << END
0.13 20.344 "passes=3"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-32-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  38.4424 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.7229 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
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
set output 'accuracy-hanging-32-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  38.4424 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.7229 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
