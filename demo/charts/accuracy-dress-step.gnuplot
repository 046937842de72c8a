set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.1505:40.9792]
set yrange [0.451859:4.62662]
set ytics (0.5, 1, 2)
set title 'Dress hung by its neck, 4589 particles: distance from the converged step' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles after one step [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f+; κ = 1504; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Chebyshev iterations=128; Chebyshev iterations=16; Chebyshev iterations=32; Chebyshev iterations=4; Chebyshev iterations=64'."\n".' Chebyshev iterations=8; Conjugate gradients iterations=128; Conjugate gradients iterations=16; Conjugate gradients iterations=32'."\n".' Conjugate gradients iterations=4; Conjugate gradients iterations=64; Conjugate gradients iterations=8; Jacobi (Kang) in substeps iterations=7 substeps=16'."\n".' Jacobi (Kang) in substeps iterations=7 substeps=2; Jacobi (Kang) in substeps iterations=7 substeps=4; Jacobi (Kang) in substeps iterations=7 substeps=8'."\n".' Jacobi (Kang) with tethers iterations=1; Jacobi (Kang) with tethers iterations=127; Jacobi (Kang) with tethers iterations=31'."\n".' Jacobi (Kang) with tethers iterations=7; Jacobi (Kang): even iterations=16; Jacobi (Kang): even iterations=2; Jacobi (Kang): even iterations=64'."\n".' Jacobi (Kang): even iterations=8; Jacobi (Kang): odd iterations=1; Jacobi (Kang): odd iterations=127; Jacobi (Kang): odd iterations=15'."\n".' Jacobi (Kang): odd iterations=255; Jacobi (Kang): odd iterations=3; Jacobi (Kang): odd iterations=31; Jacobi (Kang): odd iterations=63'."\n".' Jacobi (Kang): odd iterations=7; Sparse Cholesky one factorisation a step' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.215 2.89164 "substeps=1"
0.242 2.88882 "iterations=1"
0.316 2.84946 "iterations=4"
0.398 2.2995 "substeps=2"
0.765 2.05 "substeps=4"
1.512 1.89293 "substeps=8"
1.907 1.39885 "passes=2"
2.492 1.25913 "passes=4"
3.724 1.05858 "passes=6"
4.785 0.933936 "passes=8"
7.123 0.842965 "passes=12"
10.609 0.793186 "passes=18"
13.408 0.645513 "iterations=1 substeps=64"
END
$curve0 << END
1.907 1.39885 "passes=2"
1.919 1.39885 "passes=1"
1.95 1.39885 "passes=3"
2.492 1.25913 "passes=4"
3.724 1.05858 "passes=6"
4.785 0.933936 "passes=8"
7.123 0.842965 "passes=12"
10.609 0.793186 "passes=18"
END
$curve1 << END
4.105 1.06751 "passes=1 substeps=2"
7.503 0.929617 "passes=1 substeps=4"
13.729 0.912246 "passes=1 substeps=8"
25.612 0.974952 "passes=1 substeps=16"
END
$curve2 << END
0.215 2.89164 "substeps=1"
0.398 2.2995 "substeps=2"
0.765 2.05 "substeps=4"
1.512 1.89293 "substeps=8"
2.961 1.65451 "substeps=16"
5.892 1.26093 "substeps=32"
11.659 0.82902 "substeps=64"
END
$curve3 << END
0.316 2.84946 "iterations=4"
0.727 2.78897 "iterations=16"
2.371 2.65797 "iterations=64"
END
$curve4 << END
0.242 2.88882 "iterations=1"
0.414 2.83504 "iterations=4"
1.107 2.71901 "iterations=16"
3.972 2.34619 "iterations=64"
END
$curve5 << END
0.871 2.06825 "iterations=1 substeps=4"
3.415 1.49551 "iterations=1 substeps=16"
13.408 0.645513 "iterations=1 substeps=64"
END
$default << END
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-dress-step.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-dress-step.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle
