set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0696619:325.386]
set yrange [10.0046:151.793]
set ytics (20, 50, 100)
set title 'T-shirt hung by its neck, 3546 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 5
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 8572a2e; κ = 2923; weft_study accuracy, then weft_study plot' at screen 0.012, screen 0.022 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.099517 23.2585 "iterations=1"
0.131646 18.9853 "iterations=3"
0.192963 19.8243 "iterations=7"
0.315368 17.7404 "iterations=15"
0.57305 15.1417 "iterations=31"
1.0819 14.6348 "iterations=63"
2.14953 14.6584 "iterations=127"
4.32132 14.6715 "iterations=255"
END
$curve1 << END
0.120451 77.1308 "iterations=2"
0.244874 49.9803 "iterations=8"
0.404155 31.6898 "iterations=16"
1.37938 14.6358 "iterations=64"
END
$curve2 << END
0.121586 23.2585 "iterations=1"
0.229849 19.8243 "iterations=7"
0.694891 15.1417 "iterations=31"
2.66768 14.6584 "iterations=127"
END
$curve3 << END
0.419836 14.6445 "iterations=7 substeps=2"
0.712933 14.6813 "iterations=7 substeps=4"
1.44323 14.7435 "iterations=7 substeps=8"
2.91087 14.7493 "iterations=7 substeps=16"
END
$curve4 << END
0.162764 18.1615 "iterations=4"
0.231139 14.5998 "iterations=8"
0.362826 15.8258 "iterations=16"
0.593136 14.6897 "iterations=32"
1.15857 14.5598 "iterations=64"
2.17511 14.2923 "iterations=128"
END
$curve5 << END
0.214024 28.7711 "iterations=4"
0.349654 14.5993 "iterations=8"
0.67456 14.6921 "iterations=16"
1.17483 14.6744 "iterations=32"
2.23526 14.5967 "iterations=64"
4.48917 14.4358 "iterations=128"
END
$curve6 << END
0.36816 14.6615 "iterations=1"
0.537998 14.6835 "iterations=2"
0.622791 14.6924 "iterations=3"
0.756335 14.6995 "iterations=4"
1.0848 14.7033 "iterations=6"
1.34351 14.698 "iterations=8"
1.89072 14.6908 "iterations=12"
2.35122 14.6806 "iterations=16"
END
$curve7 << END
0.240208 14.6615 "iterations=1"
0.337695 14.6951 "iterations=2"
0.540274 14.7079 "iterations=4"
0.910309 14.6778 "iterations=8"
END
$curve8 << END
0.372661 14.6797 "passes=2 iterations=1"
0.4608 14.6936 "passes=2 iterations=2"
0.568409 14.6929 "passes=3 iterations=1"
0.633699 14.7003 "passes=3 iterations=2"
0.652357 14.6955 "passes=2 iterations=4"
0.653788 14.6977 "passes=4 iterations=1"
0.772774 14.7019 "passes=4 iterations=2"
0.809736 14.6907 "passes=3 iterations=4"
0.870503 14.6832 "passes=2 iterations=6"
0.919225 14.6981 "passes=6 iterations=1"
0.937539 14.6861 "passes=4 iterations=4"
0.999524 14.6742 "passes=3 iterations=6"
1.01695 14.6922 "passes=6 iterations=2"
1.19873 14.6926 "passes=8 iterations=1"
1.27878 14.68 "passes=8 iterations=2"
END
$curve9 << END
0.487283 14.6576 "passes=1 substeps=2"
0.936772 14.6767 "passes=1 substeps=4"
1.8407 14.7031 "passes=1 substeps=8"
3.61683 14.696 "passes=1 substeps=16"
END
$curve10 << END
0.109498 35.3403 "substeps=1"
0.199938 33.7071 "substeps=2"
0.380656 40.5292 "substeps=4"
0.738656 41.5976 "substeps=8"
1.4838 36.2046 "substeps=16"
2.9472 28.7082 "substeps=32"
5.80353 21.7395 "substeps=64"
END
$curve11 << END
0.299804 31.8069 "iterations=4"
1.1193 46.2173 "iterations=16"
4.20886 43.7055 "iterations=64"
END
$curve12 << END
0.211075 39.4153 "iterations=1"
0.691692 74.7692 "iterations=4"
2.67056 46.9303 "iterations=16"
10.4648 65.9579 "iterations=64"
END
$curve13 << END
0.788231 94.8704 "iterations=1 substeps=4"
3.14498 41.3919 "iterations=1 substeps=16"
12.5449 14.8443 "iterations=1 substeps=64"
END
$curve14 << END
28.6688 14.6971 "substeps=640"
44.5741 14.6948 "substeps=985"
87.6151 14.6901 "substeps=1969"
END
$curve15 << END
39.576 14.699 "substeps=640"
121.614 14.6915 "substeps=1969"
END
$curve16 << END
203.366 14.4477 "one factorisation a step"
END
$default << END
0.633699 14.7003 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-tshirt-stretch.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
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
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-tshirt-stretch.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
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
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
