set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.1365:22.9088]
set yrange [7.9576:142.924]
set ytics (10, 20, 50, 100)
set title 'T-shirt hung by its neck, 3546 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 2923; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Chebyshev iterations=128; Chebyshev iterations=16; Chebyshev iterations=32; Chebyshev iterations=4; Chebyshev iterations=64'."\n".' Chebyshev iterations=8; Conjugate gradients iterations=128; Conjugate gradients iterations=16; Conjugate gradients iterations=32'."\n".' Conjugate gradients iterations=4; Conjugate gradients iterations=64; Conjugate gradients iterations=8; Jacobi (Kang) in substeps iterations=7 substeps=16'."\n".' Jacobi (Kang) in substeps iterations=7 substeps=2; Jacobi (Kang) in substeps iterations=7 substeps=4; Jacobi (Kang) in substeps iterations=7 substeps=8'."\n".' Jacobi (Kang) with tethers iterations=1; Jacobi (Kang) with tethers iterations=127; Jacobi (Kang) with tethers iterations=31'."\n".' Jacobi (Kang) with tethers iterations=7; Jacobi (Kang): even iterations=16; Jacobi (Kang): even iterations=2; Jacobi (Kang): even iterations=64'."\n".' Jacobi (Kang): even iterations=8; Jacobi (Kang): odd iterations=1; Jacobi (Kang): odd iterations=127; Jacobi (Kang): odd iterations=15'."\n".' Jacobi (Kang): odd iterations=255; Jacobi (Kang): odd iterations=3; Jacobi (Kang): odd iterations=31; Jacobi (Kang): odd iterations=63'."\n".' Jacobi (Kang): odd iterations=7; Sparse Cholesky one factorisation a step' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.492 26.0414 "iterations=1"
0.858 19.6499 "iterations=2"
2.027 11.8861 "iterations=4"
2.731 12.2944 "iterations=8"
END
$curve1 << END
1.062 15.4069 "passes=2 iterations=1"
1.255 12.2384 "passes=4 iterations=1"
1.332 12.2384 "passes=3 iterations=1"
1.587 11.4857 "passes=4 iterations=2"
1.635 11.4857 "passes=2 iterations=2"
1.657 11.4857 "passes=3 iterations=2"
1.801 11.368 "passes=6 iterations=1"
1.947 11.8861 "passes=4 iterations=4"
2.036 11.8861 "passes=2 iterations=4"
2.061 11.8861 "passes=3 iterations=4"
2.231 11.825 "passes=6 iterations=2"
2.362 12.1523 "passes=3 iterations=6"
2.37 12.1523 "passes=2 iterations=6"
2.409 11.5868 "passes=8 iterations=1"
2.929 12.073 "passes=8 iterations=2"
END
$curve2 << END
1.013 20.878 "passes=1 substeps=2"
2.005 11.8448 "passes=1 substeps=4"
3.922 13.2111 "passes=1 substeps=8"
7.698 13.3586 "passes=1 substeps=16"
END
$curve3 << END
0.195 80.2336 "substeps=1"
0.364 53.9301 "substeps=2"
0.705 30.4047 "substeps=4"
1.386 29.1541 "substeps=8"
2.743 21.7346 "substeps=16"
5.48 19.7738 "substeps=32"
10.899 15.3347 "substeps=64"
END
$curve4 << END
0.289 50.6773 "iterations=4"
0.657 24.8255 "iterations=16"
2.163 27.6939 "iterations=64"
END
$curve5 << END
0.247 89.3277 "iterations=1"
0.49 28.7891 "iterations=4"
1.485 21.41 "iterations=16"
5.44 17.6567 "iterations=64"
END
$curve6 << END
0.918 44.1732 "iterations=1 substeps=4"
3.606 21.0531 "iterations=1 substeps=16"
14.318 11.6834 "iterations=1 substeps=64"
END
$default << END
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-tshirt-stretch.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-tshirt-stretch.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps'
