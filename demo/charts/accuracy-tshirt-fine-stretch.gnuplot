set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.5222:161.058]
set yrange [8.52439:359.939]
set ytics (10, 20, 50, 100, 200)
set title 'T-shirt hung by its neck, 14048 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f+; κ = 11579; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Chebyshev iterations=128; Chebyshev iterations=16; Chebyshev iterations=32; Chebyshev iterations=4; Chebyshev iterations=64'."\n".' Chebyshev iterations=8; Conjugate gradients iterations=128; Conjugate gradients iterations=16; Conjugate gradients iterations=32'."\n".' Conjugate gradients iterations=4; Conjugate gradients iterations=64; Conjugate gradients iterations=8; Jacobi (Kang) in substeps iterations=7 substeps=16'."\n".' Jacobi (Kang) in substeps iterations=7 substeps=2; Jacobi (Kang) in substeps iterations=7 substeps=4; Jacobi (Kang) in substeps iterations=7 substeps=8'."\n".' Jacobi (Kang) with tethers iterations=1; Jacobi (Kang) with tethers iterations=127; Jacobi (Kang) with tethers iterations=31'."\n".' Jacobi (Kang) with tethers iterations=7; Jacobi (Kang): even iterations=16; Jacobi (Kang): even iterations=2; Jacobi (Kang): even iterations=64'."\n".' Jacobi (Kang): even iterations=8; Jacobi (Kang): odd iterations=1; Jacobi (Kang): odd iterations=127; Jacobi (Kang): odd iterations=15'."\n".' Jacobi (Kang): odd iterations=255; Jacobi (Kang): odd iterations=3; Jacobi (Kang): odd iterations=31; Jacobi (Kang): odd iterations=63'."\n".' Jacobi (Kang): odd iterations=7' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
8.457 14.2188 "passes=1"
9.041 12.2456 "passes=3"
9.055 12.2456 "passes=2"
9.075 12.2456 "passes=4"
13.51 12.2107 "passes=6"
18 13.3051 "passes=8"
26.785 14.1549 "passes=12"
39.864 14.2046 "passes=18"
END
$curve1 << END
16.57 12.1777 "passes=1 substeps=2"
31.384 13.9943 "passes=1 substeps=4"
59.533 15.1365 "passes=1 substeps=8"
100.661 15.4756 "passes=1 substeps=16"
END
$curve2 << END
0.746 91.3979 "substeps=1"
1.38 58.0998 "substeps=2"
2.654 47.5082 "substeps=4"
5.186 41.0339 "substeps=8"
10.246 37.2836 "substeps=16"
20.507 23.2793 "substeps=32"
40.588 18.9549 "substeps=64"
END
$curve3 << END
1.149 76.5535 "iterations=4"
2.399 42.3303 "iterations=16"
7.59 26.9937 "iterations=64"
END
$curve4 << END
0.954 224.962 "iterations=1"
1.826 144.099 "iterations=4"
5.17 85.0839 "iterations=16"
18.614 77.7818 "iterations=64"
END
$curve5 << END
3.431 121.757 "iterations=1 substeps=4"
13.33 65.4356 "iterations=1 substeps=16"
52.744 46.5653 "iterations=1 substeps=64"
END
$default << END
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-tshirt-fine-stretch.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-tshirt-fine-stretch.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps'
