set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0133:20.624]
set yrange [0.493837:5869.12]
set title 'Sheet hung by two corners, 32 × 32 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=47; Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.019 235.545 "iterations=1"
0.024 330.709 "iterations=3"
0.036 147.956 "iterations=7"
0.057 76.6141 "iterations=15"
0.1 42.2316 "iterations=31"
0.185 32.092 "iterations=63"
0.357 9.39345 "iterations=127"
0.707 9.26471 "iterations=255"
END
$curve1 << END
0.022 572.846 "iterations=2"
0.039 296.783 "iterations=8"
0.061 191.447 "iterations=16"
0.188 137.801 "iterations=64"
END
$curve2 << END
0.033 34.2933 "iterations=1"
0.048 4.48142 "iterations=7"
0.114 4.55301 "iterations=31"
0.37 2.96192 "iterations=127"
END
$curve3 << END
0.067 101.465 "iterations=7 substeps=2"
0.128 0.705482 "iterations=7 substeps=4"
0.251 8.67429 "iterations=7 substeps=8"
0.475 7.00625 "iterations=7 substeps=16"
END
$curve4 << END
0.028 102.774 "iterations=4"
0.04 46.1036 "iterations=8"
0.062 7.28048 "iterations=16"
0.106 8.30216 "iterations=32"
0.196 7.72282 "iterations=64"
0.376 7.17079 "iterations=128"
END
$curve5 << END
0.037 104.407 "iterations=4"
0.059 20.6556 "iterations=8"
0.103 13.3522 "iterations=16"
0.191 7.85038 "iterations=32"
0.368 7.10935 "iterations=64"
0.722 7.2983 "iterations=128"
END
$curve6 << END
0.095 8.45342 "passes=2"
0.096 8.51691 "passes=1"
0.127 7.78954 "passes=3"
0.159 7.61032 "passes=4"
0.223 7.54504 "passes=6"
0.287 7.56493 "passes=8"
0.418 7.61169 "passes=12"
0.611 7.63231 "passes=18"
END
$curve7 << END
0.184 8.30509 "passes=1 substeps=2"
0.367 7.52416 "passes=1 substeps=4"
0.724 7.20362 "passes=1 substeps=8"
1.464 6.10868 "passes=1 substeps=16"
END
$curve8 << END
0.107 4.75529 "passes=1"
0.128 4.21187 "passes=2"
0.13 5.029 "passes=3"
0.161 4.1206 "passes=4"
0.235 4.52687 "passes=6"
0.295 4.89551 "passes=8"
0.423 4.84873 "passes=12"
END
$curve9 << END
0.241 4.55175 "passes=1 substeps=2"
0.253 5.41081 "passes=3 substeps=2"
0.436 5.3535 "passes=1 substeps=4"
0.503 4.89067 "passes=3 substeps=4"
0.79 5.39275 "passes=1 substeps=8"
1.022 3.79655 "passes=3 substeps=8"
END
$curve10 << END
0.302 8.29618 "passes=1"
0.307 8.22473 "passes=2"
0.41 7.85207 "passes=3"
0.515 7.84215 "passes=4"
0.723 7.8913 "passes=6"
END
$curve11 << END
0.047 3668.2 "substeps=1"
0.082 1069.8 "substeps=2"
0.16 140.585 "substeps=4"
0.316 18.4973 "substeps=8"
0.629 5.69081 "substeps=16"
1.246 3.92418 "substeps=32"
2.54 5.58488 "substeps=64"
END
$curve12 << END
0.073 1013.63 "iterations=4"
0.184 121.335 "iterations=16"
0.632 24.9797 "iterations=64"
END
$curve13 << END
0.086 789.815 "iterations=4"
0.231 48.2487 "iterations=16"
0.837 20.8963 "iterations=64"
END
$curve14 << END
0.181 79.8166 "iterations=1 substeps=4"
0.706 7.33028 "iterations=1 substeps=16"
2.814 6.64462 "iterations=1 substeps=64"
END
$curve15 << END
0.363 4.951 "substeps=47"
0.549 4.60498 "substeps=71"
1.101 5.89326 "substeps=142"
END
$curve16 << END
1.673 3.17768 "substeps=142"
END
$curve17 << END
12.89 7.29977 "one factorisation a step"
END
$default << END
0.13 5.029 "passes=3"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-32-stretch.svg'
plot 5.11611 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-32-stretch.png'
plot 5.11611 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
