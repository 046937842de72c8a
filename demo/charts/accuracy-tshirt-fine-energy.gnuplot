set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.5446:92.7872]
set yrange [0.0377437:2.38774]
set ytics (0.05, 0.1, 0.2, 0.5, 1, 2)
set title 'T-shirt hung by its neck, 14048 particles: energy left above the converged step' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'energy gap over that of the inertial start'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 11579; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Chebyshev iterations=128; Chebyshev iterations=16; Chebyshev iterations=32; Chebyshev iterations=4; Chebyshev iterations=64'."\n".' Chebyshev iterations=8; Conjugate gradients iterations=128; Conjugate gradients iterations=16; Conjugate gradients iterations=32'."\n".' Conjugate gradients iterations=4; Conjugate gradients iterations=64; Conjugate gradients iterations=8; Jacobi (Kang) in substeps iterations=7 substeps=16'."\n".' Jacobi (Kang) in substeps iterations=7 substeps=2; Jacobi (Kang) in substeps iterations=7 substeps=4; Jacobi (Kang) in substeps iterations=7 substeps=8'."\n".' Jacobi (Kang) with tethers iterations=1; Jacobi (Kang) with tethers iterations=127; Jacobi (Kang) with tethers iterations=31'."\n".' Jacobi (Kang) with tethers iterations=7; Jacobi (Kang): even iterations=16; Jacobi (Kang): even iterations=2; Jacobi (Kang): even iterations=64'."\n".' Jacobi (Kang): even iterations=8; Jacobi (Kang): odd iterations=1; Jacobi (Kang): odd iterations=127; Jacobi (Kang): odd iterations=15'."\n".' Jacobi (Kang): odd iterations=255; Jacobi (Kang): odd iterations=3; Jacobi (Kang): odd iterations=31; Jacobi (Kang): odd iterations=63'."\n".' Jacobi (Kang): odd iterations=7' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.778 0.800865 "substeps=1"
1.216 0.409147 "iterations=4"
2.939 0.238383 "iterations=16"
3.084 0.115508 "iterations=1"
4.798 0.0706845 "iterations=2"
5.664 0.0554272 "passes=3 iterations=1"
7.46 0.054658 "passes=3 iterations=2"
8.465 0.0539196 "passes=6 iterations=1"
END
$curve0 << END
3.084 0.115508 "iterations=1"
4.798 0.0706845 "iterations=2"
9.706 0.056926 "iterations=4"
12.424 0.0563765 "iterations=8"
END
$curve1 << END
5.664 0.0554272 "passes=3 iterations=1"
5.822 0.061612 "passes=2 iterations=1"
6.109 0.0562252 "passes=4 iterations=1"
7.36 0.0575238 "passes=4 iterations=2"
7.46 0.054658 "passes=3 iterations=2"
7.644 0.054658 "passes=2 iterations=2"
8.465 0.0539196 "passes=6 iterations=1"
8.764 0.056926 "passes=3 iterations=4"
9.09 0.056926 "passes=2 iterations=4"
9.93 0.0583007 "passes=4 iterations=4"
10.652 0.0569404 "passes=2 iterations=6"
11.036 0.0588783 "passes=6 iterations=2"
11.417 0.0569404 "passes=3 iterations=6"
12.046 0.0539241 "passes=8 iterations=1"
13.907 0.0598187 "passes=8 iterations=2"
END
$curve2 << END
5.923 0.0832624 "passes=1 substeps=2"
11.771 0.0856825 "passes=1 substeps=4"
22.108 0.088264 "passes=1 substeps=8"
46.307 0.0705284 "passes=1 substeps=16"
END
$curve3 << END
0.778 0.800865 "substeps=1"
1.518 0.532629 "substeps=2"
2.977 0.483285 "substeps=4"
5.762 0.476376 "substeps=8"
11.406 0.410215 "substeps=16"
22.641 0.270337 "substeps=32"
44.978 0.142019 "substeps=64"
END
$curve4 << END
1.216 0.409147 "iterations=4"
2.939 0.238383 "iterations=16"
9.544 0.154164 "iterations=64"
END
$curve5 << END
1.011 1.49234 "iterations=1"
2.036 0.675206 "iterations=4"
5.989 0.405816 "iterations=16"
21.325 0.251202 "iterations=64"
END
$curve6 << END
3.774 0.626338 "iterations=1 substeps=4"
14.68 0.3826 "iterations=1 substeps=16"
57.992 0.116179 "iterations=1 substeps=64"
END
$default << END
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-tshirt-fine-energy.svg'
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
set output 'accuracy-tshirt-fine-energy.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle
