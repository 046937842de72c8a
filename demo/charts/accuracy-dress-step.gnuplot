set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.1715:25.2848]
set yrange [0.467559:4.6551]
set ytics (0.5, 1, 2)
set title 'Dress hung by its neck, 4589 particles: distance from the converged step' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles after one step [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 1504; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Chebyshev iterations=128; Chebyshev iterations=16; Chebyshev iterations=32; Chebyshev iterations=4; Chebyshev iterations=64'."\n".' Chebyshev iterations=8; Conjugate gradients iterations=128; Conjugate gradients iterations=16; Conjugate gradients iterations=32'."\n".' Conjugate gradients iterations=4; Conjugate gradients iterations=64; Conjugate gradients iterations=8; Jacobi (Kang) in substeps iterations=7 substeps=16'."\n".' Jacobi (Kang) in substeps iterations=7 substeps=2; Jacobi (Kang) in substeps iterations=7 substeps=4; Jacobi (Kang) in substeps iterations=7 substeps=8'."\n".' Jacobi (Kang) with tethers iterations=1; Jacobi (Kang) with tethers iterations=127; Jacobi (Kang) with tethers iterations=31'."\n".' Jacobi (Kang) with tethers iterations=7; Jacobi (Kang): even iterations=16; Jacobi (Kang): even iterations=2; Jacobi (Kang): even iterations=64'."\n".' Jacobi (Kang): even iterations=8; Jacobi (Kang): odd iterations=1; Jacobi (Kang): odd iterations=127; Jacobi (Kang): odd iterations=15'."\n".' Jacobi (Kang): odd iterations=255; Jacobi (Kang): odd iterations=3; Jacobi (Kang): odd iterations=31; Jacobi (Kang): odd iterations=63'."\n".' Jacobi (Kang): odd iterations=7; Sparse Cholesky one factorisation a step' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.245 2.90944 "substeps=1"
0.272 2.90678 "iterations=1"
0.362 2.8648 "iterations=4"
0.461 2.31558 "substeps=2"
0.618 0.821638 "iterations=1"
0.874 0.791927 "passes=2 iterations=1"
1.201 0.791764 "passes=3 iterations=1"
2.709 0.780491 "iterations=8"
15.803 0.667941 "iterations=1 substeps=64"
END
$curve0 << END
0.618 0.821638 "iterations=1"
1.243 0.842798 "iterations=2"
1.78 0.825576 "iterations=4"
2.709 0.780491 "iterations=8"
END
$curve1 << END
0.874 0.791927 "passes=2 iterations=1"
1.141 0.809733 "passes=2 iterations=2"
1.201 0.791764 "passes=3 iterations=1"
1.537 0.830833 "passes=3 iterations=2"
1.543 0.805675 "passes=4 iterations=1"
1.592 0.825576 "passes=2 iterations=4"
1.928 0.841585 "passes=4 iterations=2"
1.999 0.820974 "passes=3 iterations=4"
2.054 0.796273 "passes=2 iterations=6"
2.244 0.806304 "passes=6 iterations=1"
2.403 0.815425 "passes=4 iterations=4"
2.438 0.792144 "passes=3 iterations=6"
2.751 0.830333 "passes=6 iterations=2"
2.949 0.803022 "passes=8 iterations=1"
3.604 0.815053 "passes=8 iterations=2"
END
$curve2 << END
1.347 0.813826 "passes=1 substeps=2"
2.705 0.845681 "passes=1 substeps=4"
5.38 0.897607 "passes=1 substeps=8"
9.98 0.948007 "passes=1 substeps=16"
END
$curve3 << END
0.245 2.90944 "substeps=1"
0.461 2.31558 "substeps=2"
0.899 2.06256 "substeps=4"
1.769 1.89917 "substeps=8"
3.534 1.65902 "substeps=16"
7.037 1.26632 "substeps=32"
13.983 0.836627 "substeps=64"
END
$curve4 << END
0.362 2.8648 "iterations=4"
0.838 2.80197 "iterations=16"
2.738 2.66802 "iterations=64"
END
$curve5 << END
0.272 2.90678 "iterations=1"
0.462 2.85051 "iterations=4"
1.255 2.73326 "iterations=16"
4.346 2.36102 "iterations=64"
END
$curve6 << END
1.021 2.08268 "iterations=1 substeps=4"
3.953 1.51947 "iterations=1 substeps=16"
15.803 0.667941 "iterations=1 substeps=64"
END
$default << END
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-dress-step.svg'
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
set output 'accuracy-dress-step.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle
