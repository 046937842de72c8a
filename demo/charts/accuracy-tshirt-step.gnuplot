set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.1204:35.3696]
set yrange [0.558722:4.72446]
set ytics (1, 2)
set title 'T-shirt hung by its neck, 3546 particles: distance from the converged step' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles after one step [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f+; κ = 2923; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Chebyshev iterations=128; Chebyshev iterations=16; Chebyshev iterations=32; Chebyshev iterations=4; Chebyshev iterations=64'."\n".' Chebyshev iterations=8; Conjugate gradients iterations=128; Conjugate gradients iterations=16; Conjugate gradients iterations=32'."\n".' Conjugate gradients iterations=4; Conjugate gradients iterations=64; Conjugate gradients iterations=8; Jacobi (Kang) in substeps iterations=7 substeps=16'."\n".' Jacobi (Kang) in substeps iterations=7 substeps=2; Jacobi (Kang) in substeps iterations=7 substeps=4; Jacobi (Kang) in substeps iterations=7 substeps=8'."\n".' Jacobi (Kang) with tethers iterations=1; Jacobi (Kang) with tethers iterations=127; Jacobi (Kang) with tethers iterations=31'."\n".' Jacobi (Kang) with tethers iterations=7; Jacobi (Kang): even iterations=16; Jacobi (Kang): even iterations=2; Jacobi (Kang): even iterations=64'."\n".' Jacobi (Kang): even iterations=8; Jacobi (Kang): odd iterations=1; Jacobi (Kang): odd iterations=127; Jacobi (Kang): odd iterations=15'."\n".' Jacobi (Kang): odd iterations=255; Jacobi (Kang): odd iterations=3; Jacobi (Kang): odd iterations=31; Jacobi (Kang): odd iterations=63'."\n".' Jacobi (Kang): odd iterations=7; Sparse Cholesky one factorisation a step' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.172 2.95279 "substeps=1"
0.226 2.93653 "iterations=1"
0.249 2.90414 "iterations=4"
0.322 2.38204 "substeps=2"
0.609 2.23896 "substeps=4"
0.798 2.19742 "iterations=1 substeps=4"
1.671 1.7585 "passes=1"
1.856 1.47487 "passes=2"
1.889 1.34127 "passes=3"
1.931 1.30545 "passes=4"
2.782 1.10894 "passes=6"
3.741 0.987324 "passes=8"
5.45 0.877433 "passes=12"
8.142 0.798175 "passes=18"
END
$curve0 << END
1.671 1.7585 "passes=1"
1.856 1.47487 "passes=2"
1.889 1.34127 "passes=3"
1.931 1.30545 "passes=4"
2.782 1.10894 "passes=6"
3.741 0.987324 "passes=8"
5.45 0.877433 "passes=12"
8.142 0.798175 "passes=18"
END
$curve1 << END
3.431 1.21295 "passes=1 substeps=2"
6.416 1.07575 "passes=1 substeps=4"
12.188 0.980914 "passes=1 substeps=8"
22.106 0.956134 "passes=1 substeps=16"
END
$curve2 << END
0.172 2.95279 "substeps=1"
0.322 2.38204 "substeps=2"
0.609 2.23896 "substeps=4"
1.176 2.26866 "substeps=8"
2.349 2.11849 "substeps=16"
4.614 1.70178 "substeps=32"
9.092 1.15397 "substeps=64"
END
$curve3 << END
0.249 2.90414 "iterations=4"
0.568 2.83601 "iterations=16"
1.863 2.68648 "iterations=64"
END
$curve4 << END
0.226 2.93653 "iterations=1"
0.44 2.87005 "iterations=4"
1.35 2.75556 "iterations=16"
4.904 2.51423 "iterations=64"
END
$curve5 << END
0.798 2.19742 "iterations=1 substeps=4"
3.145 2.0099 "iterations=1 substeps=16"
12.598 1.00277 "iterations=1 substeps=64"
END
$default << END
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-tshirt-step.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-tshirt-step.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle
