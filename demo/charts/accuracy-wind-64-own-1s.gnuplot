set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0574:262.45]
set yrange [0.604269:556.84]
set title 'Hung sheet in wind, 64 × 64 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=126; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.082 92.9578 "iterations=1"
0.11 106.253 "iterations=3"
0.159 137.309 "iterations=7"
0.254 145.353 "iterations=15"
0.435 87.0062 "iterations=31"
0.825 44.3475 "iterations=63"
1.584 32.4788 "iterations=127"
3.124 22.5354 "iterations=255"
END
$curve1 << END
0.171 279.734 "iterations=8"
0.269 348.025 "iterations=16"
0.855 235.791 "iterations=64"
END
$curve2 << END
0.122 49.6909 "iterations=1"
0.193 121.992 "iterations=7"
0.484 86.302 "iterations=31"
1.57 42.7169 "iterations=127"
END
$curve3 << END
0.125 153.138 "iterations=4"
0.175 74.9731 "iterations=8"
0.269 29.215 "iterations=16"
0.469 17.3766 "iterations=32"
0.874 12.4147 "iterations=64"
1.641 13.6725 "iterations=128"
END
$curve4 << END
0.166 150.328 "iterations=4"
0.262 64.8484 "iterations=8"
0.462 28.3495 "iterations=16"
0.857 17.1861 "iterations=32"
1.658 13.3691 "iterations=64"
3.254 13.2566 "iterations=128"
END
$curve5 << END
0.287 24.7498 "passes=1"
0.436 7.21802 "passes=2"
0.581 3.66114 "passes=3"
0.736 2.70413 "passes=4"
1.042 2.01042 "passes=6"
1.323 1.23774 "passes=8"
1.893 1.49774 "passes=12"
2.806 0.863241 "passes=18"
END
$curve6 << END
0.448 20.9191 "passes=2"
0.459 20.5025 "passes=1"
0.608 19.9847 "passes=3"
0.768 22.3491 "passes=4"
1.069 3.90135 "passes=6"
1.375 4.45919 "passes=8"
1.949 3.08856 "passes=12"
END
$curve7 << END
1.02 51.5938 "passes=1"
1.618 26.7392 "passes=2"
2.186 13.5185 "passes=3"
2.797 12.6915 "passes=4"
3.873 9.29885 "passes=6"
END
$curve8 << END
164.031 13.3155 "one factorisation a step"
END
$default << END
0.608 19.9847 "passes=3"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-64-own-1s.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-64-own-1s.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
