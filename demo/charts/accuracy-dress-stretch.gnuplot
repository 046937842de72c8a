set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.1505:40.9792]
set yrange [16.2518:86.8006]
set ytics (20, 50)
set title 'Dress hung by its neck, 4589 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f+; κ = 1504; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Chebyshev iterations=128; Chebyshev iterations=16; Chebyshev iterations=32; Chebyshev iterations=4; Chebyshev iterations=64'."\n".' Chebyshev iterations=8; Conjugate gradients iterations=128; Conjugate gradients iterations=16; Conjugate gradients iterations=32'."\n".' Conjugate gradients iterations=4; Conjugate gradients iterations=64; Conjugate gradients iterations=8; Jacobi (Kang) in substeps iterations=7 substeps=16'."\n".' Jacobi (Kang) in substeps iterations=7 substeps=2; Jacobi (Kang) in substeps iterations=7 substeps=4; Jacobi (Kang) in substeps iterations=7 substeps=8'."\n".' Jacobi (Kang) with tethers iterations=1; Jacobi (Kang) with tethers iterations=127; Jacobi (Kang) with tethers iterations=31'."\n".' Jacobi (Kang) with tethers iterations=7; Jacobi (Kang): even iterations=16; Jacobi (Kang): even iterations=2; Jacobi (Kang): even iterations=64'."\n".' Jacobi (Kang): even iterations=8; Jacobi (Kang): odd iterations=1; Jacobi (Kang): odd iterations=127; Jacobi (Kang): odd iterations=15'."\n".' Jacobi (Kang): odd iterations=255; Jacobi (Kang): odd iterations=3; Jacobi (Kang): odd iterations=31; Jacobi (Kang): odd iterations=63'."\n".' Jacobi (Kang): odd iterations=7; Sparse Cholesky one factorisation a step' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
1.907 23.2169 "passes=2"
1.919 23.2169 "passes=1"
1.95 23.2169 "passes=3"
2.492 23.2169 "passes=4"
3.724 23.2169 "passes=6"
4.785 23.2169 "passes=8"
7.123 23.2169 "passes=12"
10.609 23.2169 "passes=18"
END
$curve1 << END
4.105 23.2169 "passes=1 substeps=2"
7.503 23.2169 "passes=1 substeps=4"
13.729 23.2169 "passes=1 substeps=8"
25.612 23.2169 "passes=1 substeps=16"
END
$curve2 << END
0.215 31.2055 "substeps=1"
0.398 32.7169 "substeps=2"
0.765 30.5737 "substeps=4"
1.512 30.1315 "substeps=8"
2.961 24.815 "substeps=16"
5.892 23.2169 "substeps=32"
11.659 23.2169 "substeps=64"
END
$curve3 << END
0.316 33.8653 "iterations=4"
0.727 32.5224 "iterations=16"
2.371 28.4232 "iterations=64"
END
$curve4 << END
0.242 51.7187 "iterations=1"
0.414 54.2504 "iterations=4"
1.107 48.2537 "iterations=16"
3.972 34.918 "iterations=64"
END
$curve5 << END
0.871 45.8078 "iterations=1 substeps=4"
3.415 23.5873 "iterations=1 substeps=16"
13.408 23.2169 "iterations=1 substeps=64"
END
$default << END
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-dress-stretch.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-dress-stretch.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps'
