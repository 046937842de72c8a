set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.1204:35.3696]
set yrange [7.34615:114.228]
set ytics (10, 20, 50, 100)
set title 'T-shirt hung by its neck, 3546 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f+; κ = 2923; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Chebyshev iterations=128; Chebyshev iterations=16; Chebyshev iterations=32; Chebyshev iterations=4; Chebyshev iterations=64'."\n".' Chebyshev iterations=8; Conjugate gradients iterations=128; Conjugate gradients iterations=16; Conjugate gradients iterations=32'."\n".' Conjugate gradients iterations=4; Conjugate gradients iterations=64; Conjugate gradients iterations=8; Jacobi (Kang) in substeps iterations=7 substeps=16'."\n".' Jacobi (Kang) in substeps iterations=7 substeps=2; Jacobi (Kang) in substeps iterations=7 substeps=4; Jacobi (Kang) in substeps iterations=7 substeps=8'."\n".' Jacobi (Kang) with tethers iterations=1; Jacobi (Kang) with tethers iterations=127; Jacobi (Kang) with tethers iterations=31'."\n".' Jacobi (Kang) with tethers iterations=7; Jacobi (Kang): even iterations=16; Jacobi (Kang): even iterations=2; Jacobi (Kang): even iterations=64'."\n".' Jacobi (Kang): even iterations=8; Jacobi (Kang): odd iterations=1; Jacobi (Kang): odd iterations=127; Jacobi (Kang): odd iterations=15'."\n".' Jacobi (Kang): odd iterations=255; Jacobi (Kang): odd iterations=3; Jacobi (Kang): odd iterations=31; Jacobi (Kang): odd iterations=63'."\n".' Jacobi (Kang): odd iterations=7; Sparse Cholesky one factorisation a step' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
1.671 11.8346 "passes=1"
1.856 12.1519 "passes=2"
1.889 12.1519 "passes=3"
1.931 12.1519 "passes=4"
2.782 12.8136 "passes=6"
3.741 13.1345 "passes=8"
5.45 13.2301 "passes=12"
8.142 13.0148 "passes=18"
END
$curve1 << END
3.431 12.8902 "passes=1 substeps=2"
6.416 13.7925 "passes=1 substeps=4"
12.188 13.7219 "passes=1 substeps=8"
22.106 13.5063 "passes=1 substeps=16"
END
$curve2 << END
0.172 71.3928 "substeps=1"
0.322 43.121 "substeps=2"
0.609 26.3159 "substeps=4"
1.176 24.6318 "substeps=8"
2.349 14.1173 "substeps=16"
4.614 11.1537 "substeps=32"
9.092 10.4945 "substeps=64"
END
$curve3 << END
0.249 41.9742 "iterations=4"
0.568 21.475 "iterations=16"
1.863 15.0991 "iterations=64"
END
$curve4 << END
0.226 45.7208 "iterations=1"
0.44 36.6039 "iterations=4"
1.35 28.4834 "iterations=16"
4.904 36.1771 "iterations=64"
END
$curve5 << END
0.798 47.4601 "iterations=1 substeps=4"
3.145 18.4197 "iterations=1 substeps=16"
12.598 10.4945 "iterations=1 substeps=64"
END
$default << END
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-tshirt-stretch.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-tshirt-stretch.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps'
