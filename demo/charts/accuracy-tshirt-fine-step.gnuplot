set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.5446:92.7872]
set yrange [0.41004:4.72906]
set ytics (0.5, 1, 2)
set title 'T-shirt hung by its neck, 14048 particles: distance from the converged step' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles after one step [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 11579; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Chebyshev iterations=128; Chebyshev iterations=16; Chebyshev iterations=32; Chebyshev iterations=4; Chebyshev iterations=64'."\n".' Chebyshev iterations=8; Conjugate gradients iterations=128; Conjugate gradients iterations=16; Conjugate gradients iterations=32'."\n".' Conjugate gradients iterations=4; Conjugate gradients iterations=64; Conjugate gradients iterations=8; Jacobi (Kang) in substeps iterations=7 substeps=16'."\n".' Jacobi (Kang) in substeps iterations=7 substeps=2; Jacobi (Kang) in substeps iterations=7 substeps=4; Jacobi (Kang) in substeps iterations=7 substeps=8'."\n".' Jacobi (Kang) with tethers iterations=1; Jacobi (Kang) with tethers iterations=127; Jacobi (Kang) with tethers iterations=31'."\n".' Jacobi (Kang) with tethers iterations=7; Jacobi (Kang): even iterations=16; Jacobi (Kang): even iterations=2; Jacobi (Kang): even iterations=64'."\n".' Jacobi (Kang): even iterations=8; Jacobi (Kang): odd iterations=1; Jacobi (Kang): odd iterations=127; Jacobi (Kang): odd iterations=15'."\n".' Jacobi (Kang): odd iterations=255; Jacobi (Kang): odd iterations=3; Jacobi (Kang): odd iterations=31; Jacobi (Kang): odd iterations=63'."\n".' Jacobi (Kang): odd iterations=7' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.778 2.95566 "substeps=1"
1.011 2.94433 "iterations=1"
1.216 2.93837 "iterations=4"
1.518 2.3277 "substeps=2"
2.977 2.03259 "substeps=4"
3.084 0.855958 "iterations=1"
4.798 0.785775 "iterations=2"
5.664 0.747763 "passes=3 iterations=1"
6.109 0.731133 "passes=4 iterations=1"
7.36 0.677097 "passes=4 iterations=2"
8.764 0.642165 "passes=3 iterations=4"
9.93 0.631336 "passes=4 iterations=4"
10.652 0.610396 "passes=2 iterations=6"
12.424 0.585771 "iterations=8"
END
$curve0 << END
3.084 0.855958 "iterations=1"
4.798 0.785775 "iterations=2"
9.706 0.642165 "iterations=4"
12.424 0.585771 "iterations=8"
END
$curve1 << END
5.664 0.747763 "passes=3 iterations=1"
5.822 0.758919 "passes=2 iterations=1"
6.109 0.731133 "passes=4 iterations=1"
7.36 0.677097 "passes=4 iterations=2"
7.46 0.693029 "passes=3 iterations=2"
7.644 0.693029 "passes=2 iterations=2"
8.465 0.696376 "passes=6 iterations=1"
8.764 0.642165 "passes=3 iterations=4"
9.09 0.642165 "passes=2 iterations=4"
9.93 0.631336 "passes=4 iterations=4"
10.652 0.610396 "passes=2 iterations=6"
11.036 0.644045 "passes=6 iterations=2"
11.417 0.610396 "passes=3 iterations=6"
12.046 0.671136 "passes=8 iterations=1"
13.907 0.622968 "passes=8 iterations=2"
END
$curve2 << END
5.923 0.798239 "passes=1 substeps=2"
11.771 0.756231 "passes=1 substeps=4"
22.108 0.74309 "passes=1 substeps=8"
46.307 0.755588 "passes=1 substeps=16"
END
$curve3 << END
0.778 2.95566 "substeps=1"
1.518 2.3277 "substeps=2"
2.977 2.03259 "substeps=4"
5.762 1.92652 "substeps=8"
11.406 1.94653 "substeps=16"
22.641 1.97733 "substeps=32"
44.978 1.83385 "substeps=64"
END
$curve4 << END
1.216 2.93837 "iterations=4"
2.939 2.90572 "iterations=16"
9.544 2.83808 "iterations=64"
END
$curve5 << END
1.011 2.94433 "iterations=1"
2.036 2.91291 "iterations=4"
5.989 2.84886 "iterations=16"
21.325 2.70748 "iterations=64"
END
$curve6 << END
3.774 2.00902 "iterations=1 substeps=4"
14.68 1.85809 "iterations=1 substeps=16"
57.992 1.59004 "iterations=1 substeps=64"
END
$default << END
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-tshirt-fine-step.svg'
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
set output 'accuracy-tshirt-fine-step.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle
