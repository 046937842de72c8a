set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [1.39754:117.04]
set xtics (2, 5, 10, 20, 50, 100)
set yrange [12.2046:437.083]
set ytics (20, 50, 100, 200)
set title 'Hung sheet in wind, 256 × 256 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 626c968+; κ = 36409; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=16; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=16; Fibres and sets iterations=4' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
2.1207 157.08 "iterations=1"
2.68312 164.071 "iterations=3"
3.67217 195.124 "iterations=7"
4.7819 227.458 "iterations=15"
9.41525 244.068 "iterations=31"
19.6345 231.686 "iterations=63"
36.962 219.217 "iterations=127"
73.1499 151.861 "iterations=255"
END
$curve1 << END
1.99648 248.326 "iterations=2"
3.78864 218.842 "iterations=8"
6.37019 273.177 "iterations=16"
20.9216 255.097 "iterations=64"
END
$curve2 << END
3.0069 151.57 "iterations=1"
4.67409 115.564 "iterations=7"
12.232 177.186 "iterations=31"
40.2002 143.652 "iterations=127"
END
$curve3 << END
2.89088 132.838 "iterations=4"
3.95438 115.33 "iterations=8"
6.15106 114.941 "iterations=16"
11.8956 98.8501 "iterations=32"
22.8706 64.1102 "iterations=64"
59.3073 60.8327 "iterations=128"
END
$curve4 << END
3.76371 158.056 "iterations=4"
5.88528 158.439 "iterations=8"
10.6825 162.254 "iterations=16"
21.2106 83.0321 "iterations=32"
36.0031 66.28 "iterations=64"
65.7725 58.0866 "iterations=128"
END
$curve5 << END
8.2025 64.8986 "iterations=2"
8.49403 66.8944 "iterations=1"
11.9278 63.9406 "iterations=3"
12.5361 63.0774 "iterations=4"
16.4748 62.2916 "iterations=6"
21.3129 60.8735 "iterations=8"
34.7016 60.9504 "iterations=12"
51.4033 59.0624 "iterations=16"
END
$curve6 << END
4.91458 68.0394 "iterations=1"
7.01824 62.5868 "iterations=2"
10.6139 86.2114 "iterations=4"
16.1809 109.963 "iterations=8"
END
$curve7 << END
7.93032 59.6888 "passes=2 iterations=1"
8.97221 54.2986 "passes=3 iterations=1"
9.54581 48.9608 "passes=2 iterations=2"
10.2895 36.148 "passes=3 iterations=2"
11.6295 26.9213 "passes=2 iterations=4"
11.9325 48.3587 "passes=4 iterations=1"
12.9419 27.2412 "passes=4 iterations=2"
13.1876 20.2265 "passes=3 iterations=4"
14.1129 23.1573 "passes=2 iterations=6"
15.7933 38.469 "passes=6 iterations=1"
16.0867 17.8312 "passes=4 iterations=4"
16.955 20.0559 "passes=3 iterations=6"
21.1082 18.8084 "passes=6 iterations=2"
25.0647 28.034 "passes=8 iterations=1"
26.102 17.4351 "passes=8 iterations=2"
END
$curve8 << END
6.15234 60.4151 "passes=1 iterations=2"
9.5201 56.3158 "passes=2 iterations=2"
12.3304 48.8736 "passes=3 iterations=2"
15.8524 38.0013 "passes=4 iterations=2"
21.2148 22.6913 "passes=4 iterations=4"
24.6385 17.7885 "passes=6 iterations=4"
END
$default << END
10.2895 36.148 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-256-own-1s.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-256-own-1s.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
