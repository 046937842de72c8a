set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.299466:3154.11]
set yrange [0.412056:4.69802]
set ytics (0.5, 1, 2)
set title 'T-shirt hung by its neck, 14048 particles: distance from the converged step' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles after one step [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 5
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 11579; weft_study accuracy, then weft_study plot' at screen 0.012, screen 0.022 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.427809 2.93626 "substeps=1"
0.489107 1.12925 "iterations=1"
0.553868 1.12737 "iterations=2"
0.591996 1.08849 "iterations=4"
0.86306 1.07787 "iterations=8"
1.09435 1.01683 "iterations=1"
1.42744 1.01062 "iterations=2"
1.88948 0.977449 "passes=2 iterations=1"
1.9389 0.940701 "passes=2 iterations=2"
2.01758 0.94045 "passes=3 iterations=1"
2.53353 0.834869 "passes=2 iterations=4"
3.79569 0.679068 "passes=3 iterations=6"
14.9019 0.627655 "passes=1 substeps=16"
538.31 0.59346 "substeps=3040"
818.553 0.592127 "substeps=4677"
1864.35 0.588651 "substeps=9353"
END
$curve0 << END
0.489107 1.12925 "iterations=1"
0.641293 1.11915 "iterations=3"
0.915619 1.10315 "iterations=7"
1.53938 1.08744 "iterations=15"
2.83656 1.07497 "iterations=31"
5.5023 1.06373 "iterations=63"
9.91574 1.05341 "iterations=127"
18.9936 1.04508 "iterations=255"
END
$curve1 << END
0.553868 1.12737 "iterations=2"
1.07029 1.09135 "iterations=8"
1.99418 1.07941 "iterations=16"
5.67879 1.06282 "iterations=64"
END
$curve2 << END
0.494642 1.13945 "iterations=1"
0.942846 1.11367 "iterations=7"
2.6474 1.0858 "iterations=31"
8.27577 1.06449 "iterations=127"
END
$curve3 << END
1.50371 1.05335 "iterations=7 substeps=2"
2.9336 1.04478 "iterations=7 substeps=4"
6.74113 1.03075 "iterations=7 substeps=8"
13.2928 0.97393 "iterations=7 substeps=16"
END
$curve4 << END
0.591996 1.08849 "iterations=4"
0.86306 1.07787 "iterations=8"
1.47748 1.0578 "iterations=16"
2.77239 1.05669 "iterations=32"
5.45302 1.08883 "iterations=64"
10.8697 1.23673 "iterations=128"
END
$curve5 << END
0.90104 1.0966 "iterations=4"
1.34957 1.0816 "iterations=8"
2.41302 1.05807 "iterations=16"
4.41327 1.05974 "iterations=32"
8.00856 1.11484 "iterations=64"
15.2209 1.22971 "iterations=128"
END
$curve6 << END
1.24227 1.01683 "iterations=1"
2.37013 0.997501 "iterations=2"
3.01387 0.981547 "iterations=3"
3.49988 0.972006 "iterations=4"
5.25872 0.96331 "iterations=6"
6.77402 0.962799 "iterations=8"
9.36239 0.94622 "iterations=12"
11.7111 0.893478 "iterations=16"
END
$curve7 << END
1.09435 1.01683 "iterations=1"
1.42744 1.01062 "iterations=2"
2.10588 0.987806 "iterations=4"
3.60014 0.941852 "iterations=8"
END
$curve8 << END
1.88948 0.977449 "passes=2 iterations=1"
1.9389 0.940701 "passes=2 iterations=2"
2.01758 0.94045 "passes=3 iterations=1"
2.53353 0.834869 "passes=2 iterations=4"
2.5868 0.88934 "passes=3 iterations=2"
2.58747 0.900158 "passes=4 iterations=1"
3.2371 0.837203 "passes=4 iterations=2"
3.79569 0.679068 "passes=3 iterations=6"
3.85421 0.76597 "passes=3 iterations=4"
4.02388 0.73392 "passes=2 iterations=6"
4.6169 0.716552 "passes=4 iterations=4"
5.0354 0.844135 "passes=6 iterations=1"
5.13796 0.799113 "passes=8 iterations=1"
5.47684 0.697628 "passes=8 iterations=2"
6.31252 0.748129 "passes=6 iterations=2"
END
$curve9 << END
2.8133 0.941187 "passes=1 substeps=2"
3.93791 0.848319 "passes=1 substeps=4"
7.58013 0.736487 "passes=1 substeps=8"
14.9019 0.627655 "passes=1 substeps=16"
END
$curve10 << END
0.427809 2.93626 "substeps=1"
0.755987 2.32267 "substeps=2"
1.10567 2.0197 "substeps=4"
2.13677 1.85945 "substeps=8"
4.12125 1.75618 "substeps=16"
9.09258 1.63916 "substeps=32"
15.5905 1.4552 "substeps=64"
END
$curve11 << END
0.840963 2.90261 "iterations=4"
3.10746 2.84882 "iterations=16"
12.1117 2.72442 "iterations=64"
END
$curve12 << END
0.866309 2.91767 "iterations=1"
2.76879 2.86976 "iterations=4"
10.7673 2.76854 "iterations=16"
42.3809 2.50176 "iterations=64"
END
$curve13 << END
3.09443 1.98674 "iterations=1 substeps=4"
12.1172 1.65227 "iterations=1 substeps=16"
48.6219 1.23449 "iterations=1 substeps=64"
END
$curve14 << END
538.31 0.59346 "substeps=3040"
818.553 0.592127 "substeps=4677"
1864.35 0.588651 "substeps=9353"
END
$curve15 << END
622.884 0.593613 "substeps=3040"
1971.32 0.588877 "substeps=9353"
END
$default << END
2.5868 0.88934 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-tshirt-fine-step.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-tshirt-fine-step.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
