set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0696619:325.386]
set yrange [0.00084413:3.94202]
set title 'T-shirt hung by its neck, 3546 particles: energy left above the converged step' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'energy gap over that of the inertial start'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 5
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 8572a2e; κ = 2923; weft_study accuracy, then weft_study plot' at screen 0.012, screen 0.022 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.099517 0.289947 "iterations=1"
0.131646 0.235674 "iterations=3"
0.162764 0.134973 "iterations=4"
0.231139 0.0964491 "iterations=8"
0.240208 0.0261645 "iterations=1"
0.337695 0.0146807 "iterations=2"
0.372661 0.00694618 "passes=2 iterations=1"
0.4608 0.00512616 "passes=2 iterations=2"
0.568409 0.00385055 "passes=3 iterations=1"
0.633699 0.0029361 "passes=3 iterations=2"
0.653788 0.00288927 "passes=4 iterations=1"
0.772774 0.00214961 "passes=4 iterations=2"
0.919225 0.00212236 "passes=6 iterations=1"
0.937539 0.00171747 "passes=4 iterations=4"
1.01695 0.00156426 "passes=6 iterations=2"
1.27878 0.00127594 "passes=8 iterations=2"
3.61683 0.0012059 "passes=1 substeps=16"
END
$curve0 << END
0.099517 0.289947 "iterations=1"
0.131646 0.235674 "iterations=3"
0.192963 0.179164 "iterations=7"
0.315368 0.128925 "iterations=15"
0.57305 0.0955261 "iterations=31"
1.0819 0.0792649 "iterations=63"
2.14953 0.071031 "iterations=127"
4.32132 0.0642337 "iterations=255"
END
$curve1 << END
0.120451 0.332918 "iterations=2"
0.244874 0.169958 "iterations=8"
0.404155 0.116365 "iterations=16"
1.37938 0.0782549 "iterations=64"
END
$curve2 << END
0.121586 0.359677 "iterations=1"
0.229849 0.248971 "iterations=7"
0.694891 0.163892 "iterations=31"
2.66768 0.135952 "iterations=127"
END
$curve3 << END
0.419836 0.0257644 "iterations=7 substeps=2"
0.712933 0.0060787 "iterations=7 substeps=4"
1.44323 0.00309116 "iterations=7 substeps=8"
2.91087 0.00199291 "iterations=7 substeps=16"
END
$curve4 << END
0.162764 0.134973 "iterations=4"
0.231139 0.0964491 "iterations=8"
0.362826 0.0718895 "iterations=16"
0.593136 0.0627817 "iterations=32"
1.15857 0.0417143 "iterations=64"
2.17511 0.0267163 "iterations=128"
END
$curve5 << END
0.214024 0.1467 "iterations=4"
0.349654 0.0909658 "iterations=8"
0.67456 0.0705705 "iterations=16"
1.17483 0.0551933 "iterations=32"
2.23526 0.0342255 "iterations=64"
4.48917 0.0252937 "iterations=128"
END
$curve6 << END
0.36816 0.0261645 "iterations=1"
0.537998 0.00973846 "iterations=2"
0.622791 0.00663747 "iterations=3"
0.756335 0.00505841 "iterations=4"
1.0848 0.00400637 "iterations=6"
1.34351 0.00314275 "iterations=8"
1.89072 0.00206319 "iterations=12"
2.35122 0.00155597 "iterations=16"
END
$curve7 << END
0.240208 0.0261645 "iterations=1"
0.337695 0.0146807 "iterations=2"
0.540274 0.0130833 "iterations=4"
0.910309 0.0125257 "iterations=8"
END
$curve8 << END
0.372661 0.00694618 "passes=2 iterations=1"
0.4608 0.00512616 "passes=2 iterations=2"
0.568409 0.00385055 "passes=3 iterations=1"
0.633699 0.0029361 "passes=3 iterations=2"
0.652357 0.0040651 "passes=2 iterations=4"
0.653788 0.00288927 "passes=4 iterations=1"
0.772774 0.00214961 "passes=4 iterations=2"
0.809736 0.00227358 "passes=3 iterations=4"
0.870503 0.00378485 "passes=2 iterations=6"
0.919225 0.00212236 "passes=6 iterations=1"
0.937539 0.00171747 "passes=4 iterations=4"
0.999524 0.00202058 "passes=3 iterations=6"
1.01695 0.00156426 "passes=6 iterations=2"
1.19873 0.00172485 "passes=8 iterations=1"
1.27878 0.00127594 "passes=8 iterations=2"
END
$curve9 << END
0.487283 0.00835673 "passes=1 substeps=2"
0.936772 0.00350197 "passes=1 substeps=4"
1.8407 0.00192863 "passes=1 substeps=8"
3.61683 0.0012059 "passes=1 substeps=16"
END
$curve10 << END
0.109498 2.46376 "substeps=1"
0.199938 2.39332 "substeps=2"
0.380656 2.21425 "substeps=4"
0.738656 1.58646 "substeps=8"
1.4838 0.847868 "substeps=16"
2.9472 0.308088 "substeps=32"
5.80353 0.083973 "substeps=64"
END
$curve11 << END
0.299804 2.17875 "iterations=4"
1.1193 1.95816 "iterations=16"
4.20886 1.3961 "iterations=64"
END
$curve12 << END
0.211075 1.70604 "iterations=1"
0.691692 1.36892 "iterations=4"
2.67056 1.10497 "iterations=16"
10.4648 0.737566 "iterations=64"
END
$curve13 << END
0.788231 1.17883 "iterations=1 substeps=4"
3.14498 0.447178 "iterations=1 substeps=16"
12.5449 0.0475171 "iterations=1 substeps=64"
END
$curve14 << END
28.6688 0.001223 "substeps=640"
44.5741 0.00122233 "substeps=985"
87.6151 0.0012202 "substeps=1969"
END
$curve15 << END
39.576 0.00123367 "substeps=640"
121.614 0.00122383 "substeps=1969"
END
$curve16 << END
203.366 0.0246133 "one factorisation a step"
END
$default << END
0.633699 0.0029361 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-tshirt-energy.svg'
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
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-tshirt-energy.png'
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
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
