set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.89901:154.803]
set yrange [12.2046:3318.78]
set title 'Hung sheet in wind, 256 × 256 particles: distance from converged backward Euler after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 626c968+; κ = 36409; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=16; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=16; Fibres and sets iterations=4' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
1.2843 1983.51 "substeps=1"
1.99648 248.326 "iterations=2"
2.1207 157.08 "iterations=1"
2.89088 132.838 "iterations=4"
3.95438 115.33 "iterations=8"
4.91458 68.0394 "iterations=1"
6.15234 59.9944 "passes=1 iterations=2"
7.93032 59.6888 "passes=2 iterations=1"
8.97221 54.2986 "passes=3 iterations=1"
9.27117 52.9194 "passes=1 substeps=2"
9.54581 48.9608 "passes=2 iterations=2"
10.2895 36.148 "passes=3 iterations=2"
11.6295 26.9213 "passes=2 iterations=4"
13.1876 20.2265 "passes=3 iterations=4"
16.0867 17.8312 "passes=4 iterations=4"
26.102 17.4351 "passes=8 iterations=2"
END
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
8.01725 255.283 "iterations=7 substeps=2"
16.2529 248.62 "iterations=7 substeps=4"
31.4235 125.013 "iterations=7 substeps=8"
55.9204 39.5262 "iterations=7 substeps=16"
END
$curve4 << END
2.89088 132.838 "iterations=4"
3.95438 115.33 "iterations=8"
6.15106 114.941 "iterations=16"
11.8956 98.8501 "iterations=32"
22.8706 64.1102 "iterations=64"
59.3073 60.8327 "iterations=128"
END
$curve5 << END
3.76371 158.056 "iterations=4"
5.88528 158.439 "iterations=8"
10.6825 162.254 "iterations=16"
21.2106 83.0321 "iterations=32"
36.0031 66.28 "iterations=64"
65.7725 58.0866 "iterations=128"
END
$curve6 << END
8.2025 64.8986 "iterations=2"
8.49403 66.8944 "iterations=1"
11.9278 63.9406 "iterations=3"
12.5361 63.0774 "iterations=4"
16.4748 62.2916 "iterations=6"
21.3129 60.8735 "iterations=8"
34.7016 60.9504 "iterations=12"
51.4033 59.0624 "iterations=16"
END
$curve7 << END
4.91458 68.0394 "iterations=1"
7.01824 62.5868 "iterations=2"
10.6139 86.2114 "iterations=4"
16.1809 109.963 "iterations=8"
END
$curve8 << END
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
$curve9 << END
9.27117 52.9194 "passes=1 substeps=2"
19.7578 20.4413 "passes=1 substeps=4"
42.1422 17.5272 "passes=1 substeps=8"
67.6443 20.4397 "passes=1 substeps=16"
END
$curve10 << END
6.15234 59.9944 "passes=1 iterations=2"
9.5201 55.9818 "passes=2 iterations=2"
12.3304 49.299 "passes=3 iterations=2"
15.8524 38.5206 "passes=4 iterations=2"
21.2148 23.7183 "passes=4 iterations=4"
24.6385 19.9767 "passes=6 iterations=4"
END
$curve11 << END
25.2898 18.5881 "passes=3 substeps=2"
54.8246 19.8278 "passes=3 substeps=4"
89.0575 23.5124 "passes=3 substeps=8"
END
$curve12 << END
1.2843 1983.51 "substeps=1"
2.66067 2074.24 "substeps=2"
4.94776 1999.85 "substeps=4"
9.45331 1579.34 "substeps=8"
18.734 758.508 "substeps=16"
37.9799 265.602 "substeps=32"
80.199 147.894 "substeps=64"
END
$curve13 << END
3.3646 1923.94 "iterations=4"
11.0673 1774.05 "iterations=16"
43.6682 1302.25 "iterations=64"
END
$curve14 << END
56.1211 1081.85 "iterations=64"
END
$curve15 << END
96.7517 103.687 "iterations=1 substeps=64"
END
$default << END
10.2895 36.148 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-256-a-1s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  64.1449 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-256-a-1s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  64.1449 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
