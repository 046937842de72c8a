set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0483:242.042]
set yrange [0.39508:1748.53]
set title 'Sheet hung by two corners, 64 × 64 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=126; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=4; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.069 1080.6 "iterations=1"
0.094 1083.42 "iterations=3"
0.14 1090.43 "iterations=7"
0.233 1068.6 "iterations=15"
0.413 980.053 "iterations=31"
0.77 813.222 "iterations=63"
1.483 662.49 "iterations=127"
2.957 539.463 "iterations=255"
END
$curve1 << END
0.144 972.96 "iterations=8"
0.233 940.762 "iterations=16"
0.788 667.531 "iterations=64"
END
$curve2 << END
0.106 1022.18 "iterations=1"
0.181 873.229 "iterations=7"
0.446 577.821 "iterations=31"
1.507 403.313 "iterations=127"
END
$curve3 << END
0.107 1084.87 "iterations=4"
0.151 936.052 "iterations=8"
0.242 607.654 "iterations=16"
0.423 382.918 "iterations=32"
0.79 101.131 "iterations=64"
1.495 57.4762 "iterations=128"
END
$curve4 << END
0.147 1092.83 "iterations=4"
0.243 944.857 "iterations=8"
0.434 649.783 "iterations=16"
0.812 327.193 "iterations=32"
1.703 87.7879 "iterations=64"
3.334 99.1865 "iterations=128"
END
$curve5 << END
0.413 18.6596 "passes=2"
0.431 18.7654 "passes=1"
0.543 8.19815 "passes=3"
0.707 3.88944 "passes=4"
0.996 2.87872 "passes=6"
1.254 2.31985 "passes=8"
1.865 0.979843 "passes=12"
2.666 0.5644 "passes=18"
END
$curve6 << END
0.548 26.806 "passes=2"
0.558 35.6131 "passes=1"
0.588 26.7337 "passes=3"
0.737 19.3295 "passes=4"
0.991 20.7641 "passes=6"
1.271 24.0919 "passes=8"
1.841 20.1367 "passes=12"
END
$curve7 << END
1.562 149.297 "passes=1"
1.597 148.766 "passes=2"
2.162 148.491 "passes=3"
2.702 163.659 "passes=4"
3.837 169.581 "passes=6"
END
$curve8 << END
151.276 86.8708 "one factorisation a step"
END
$default << END
0.588 26.7337 "passes=3"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-64-own-1s.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-64-own-1s.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
