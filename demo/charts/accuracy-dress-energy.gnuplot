set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.1715:25.2848]
set yrange [0.0563002:9.32115]
set title 'Dress hung by its neck, 4589 particles: energy left above the converged step' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'energy gap over that of the inertial start'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 1504; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Chebyshev iterations=128; Chebyshev iterations=16; Chebyshev iterations=32; Chebyshev iterations=4; Chebyshev iterations=64'."\n".' Chebyshev iterations=8; Conjugate gradients iterations=128; Conjugate gradients iterations=16; Conjugate gradients iterations=32'."\n".' Conjugate gradients iterations=4; Conjugate gradients iterations=64; Conjugate gradients iterations=8; Jacobi (Kang) in substeps iterations=7 substeps=16'."\n".' Jacobi (Kang) in substeps iterations=7 substeps=2; Jacobi (Kang) in substeps iterations=7 substeps=4; Jacobi (Kang) in substeps iterations=7 substeps=8'."\n".' Jacobi (Kang) with tethers iterations=1; Jacobi (Kang) with tethers iterations=127; Jacobi (Kang) with tethers iterations=31'."\n".' Jacobi (Kang) with tethers iterations=7; Jacobi (Kang): even iterations=16; Jacobi (Kang): even iterations=2; Jacobi (Kang): even iterations=64'."\n".' Jacobi (Kang): even iterations=8; Jacobi (Kang): odd iterations=1; Jacobi (Kang): odd iterations=127; Jacobi (Kang): odd iterations=15'."\n".' Jacobi (Kang): odd iterations=255; Jacobi (Kang): odd iterations=3; Jacobi (Kang): odd iterations=31; Jacobi (Kang): odd iterations=63'."\n".' Jacobi (Kang): odd iterations=7; Sparse Cholesky one factorisation a step' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.245 2.04256 "substeps=1"
0.362 1.00885 "iterations=4"
0.618 0.264467 "iterations=1"
0.874 0.229617 "passes=2 iterations=1"
13.983 0.0970893 "substeps=64"
15.803 0.0804289 "iterations=1 substeps=64"
END
$curve0 << END
0.618 0.264467 "iterations=1"
1.243 0.274713 "iterations=2"
1.78 0.263119 "iterations=4"
2.709 0.275583 "iterations=8"
END
$curve1 << END
0.874 0.229617 "passes=2 iterations=1"
1.141 0.257427 "passes=2 iterations=2"
1.201 0.234356 "passes=3 iterations=1"
1.537 0.270104 "passes=3 iterations=2"
1.543 0.242172 "passes=4 iterations=1"
1.592 0.263119 "passes=2 iterations=4"
1.928 0.275132 "passes=4 iterations=2"
1.999 0.27461 "passes=3 iterations=4"
2.054 0.276471 "passes=2 iterations=6"
2.244 0.251045 "passes=6 iterations=1"
2.403 0.277901 "passes=4 iterations=4"
2.438 0.279031 "passes=3 iterations=6"
2.751 0.282686 "passes=6 iterations=2"
2.949 0.258258 "passes=8 iterations=1"
3.604 0.286154 "passes=8 iterations=2"
END
$curve2 << END
1.347 0.290671 "passes=1 substeps=2"
2.705 0.369007 "passes=1 substeps=4"
5.38 0.378827 "passes=1 substeps=8"
9.98 0.333963 "passes=1 substeps=16"
END
$curve3 << END
0.245 2.04256 "substeps=1"
0.461 2.19076 "substeps=2"
0.899 1.68444 "substeps=4"
1.769 1.0291 "substeps=8"
3.534 0.628948 "substeps=16"
7.037 0.296413 "substeps=32"
13.983 0.0970893 "substeps=64"
END
$curve4 << END
0.362 1.00885 "iterations=4"
0.838 0.829186 "iterations=16"
2.738 0.725351 "iterations=64"
END
$curve5 << END
0.272 5.82572 "iterations=1"
0.462 3.67894 "iterations=4"
1.255 2.9575 "iterations=16"
4.346 1.83381 "iterations=64"
END
$curve6 << END
1.021 3.60047 "iterations=1 substeps=4"
3.953 1.06625 "iterations=1 substeps=16"
15.803 0.0804289 "iterations=1 substeps=64"
END
$default << END
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-dress-energy.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-dress-energy.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle
