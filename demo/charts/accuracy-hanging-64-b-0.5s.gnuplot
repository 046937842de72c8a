set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0489195:323.125]
set yrange [0.509993:1434.39]
set title 'Sheet hung by two corners, 64 × 64 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit d3fa699+; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.069885 664.522 "iterations=1"
0.074708 646.715 "iterations=2"
0.086641 622.542 "iterations=3"
0.12624 607.956 "iterations=7"
0.130516 591.655 "iterations=8"
0.153038 533.884 "iterations=7"
0.176951 52.9851 "iterations=1"
0.246563 50.9149 "iterations=2"
0.257298 36.1248 "passes=1 iterations=2"
0.341816 23.1666 "passes=2 iterations=2"
0.523549 20.8045 "passes=4 iterations=2"
0.683376 20.6918 "passes=4 iterations=4"
0.847334 20.1503 "passes=6 iterations=4"
0.882076 11.3185 "passes=3 substeps=2"
1.73758 5.11548 "passes=3 substeps=4"
3.506 2.60719 "passes=3 substeps=8"
5.72069 0.754771 "substeps=213"
8.79084 0.728562 "substeps=328"
END
$curve0 << END
0.069885 664.522 "iterations=1"
0.086641 622.542 "iterations=3"
0.12624 607.956 "iterations=7"
0.203647 610.706 "iterations=15"
0.349419 617.094 "iterations=31"
0.664564 597.412 "iterations=63"
1.28113 557.022 "iterations=127"
2.51178 491.28 "iterations=255"
END
$curve1 << END
0.074708 646.715 "iterations=2"
0.130516 591.655 "iterations=8"
0.205013 550.332 "iterations=16"
0.667548 577.416 "iterations=64"
END
$curve2 << END
0.09468 623.085 "iterations=1"
0.153038 533.884 "iterations=7"
0.382016 465.898 "iterations=31"
1.30798 401.311 "iterations=127"
END
$curve3 << END
0.236085 605.22 "iterations=7 substeps=2"
0.46997 509.063 "iterations=7 substeps=4"
0.920289 348.73 "iterations=7 substeps=8"
1.85456 229.479 "iterations=7 substeps=16"
END
$curve4 << END
0.105357 651.537 "iterations=4"
0.14366 612.426 "iterations=8"
0.222056 545.03 "iterations=16"
0.384137 383.405 "iterations=32"
0.709841 198.278 "iterations=64"
1.3558 73.7023 "iterations=128"
END
$curve5 << END
0.137723 632.681 "iterations=4"
0.244334 595.292 "iterations=8"
0.458177 525.811 "iterations=16"
0.908229 356.232 "iterations=32"
1.81957 149.967 "iterations=64"
3.74308 82.6578 "iterations=128"
END
$curve6 << END
0.258603 52.9548 "iterations=1"
0.33062 44.1525 "iterations=2"
0.402423 49.8618 "iterations=3"
0.546333 53.1345 "iterations=4"
0.750629 46.9191 "iterations=6"
0.948686 50.701 "iterations=8"
1.32819 40.7696 "iterations=12"
1.7154 41.5588 "iterations=16"
END
$curve7 << END
0.176951 52.9851 "iterations=1"
0.246563 50.9149 "iterations=2"
0.382044 50.7248 "iterations=4"
0.685483 50.2777 "iterations=8"
END
$curve8 << END
0.259558 56.7531 "passes=2 iterations=1"
0.338629 39.1753 "passes=2 iterations=2"
0.344936 42.213 "passes=3 iterations=1"
0.41763 40.9277 "passes=3 iterations=2"
0.439137 44.7327 "passes=4 iterations=1"
0.472378 41.3619 "passes=2 iterations=4"
0.508498 39.052 "passes=4 iterations=2"
0.600973 40.1688 "passes=3 iterations=4"
0.618281 41.1996 "passes=2 iterations=6"
0.620455 41.1242 "passes=6 iterations=1"
0.647766 39.4337 "passes=4 iterations=4"
0.697665 39.3256 "passes=6 iterations=2"
0.756293 39.9262 "passes=3 iterations=6"
0.802783 39.9715 "passes=8 iterations=1"
0.865057 38.9557 "passes=8 iterations=2"
END
$curve9 << END
0.344757 39.8748 "passes=1 substeps=2"
0.689148 26.5807 "passes=1 substeps=4"
1.42172 18.9541 "passes=1 substeps=8"
2.77164 12.5218 "passes=1 substeps=16"
END
$curve10 << END
0.257298 36.1248 "passes=1 iterations=2"
0.341816 23.1666 "passes=2 iterations=2"
0.432435 23.49 "passes=3 iterations=2"
0.523549 20.8045 "passes=4 iterations=2"
0.683376 20.6918 "passes=4 iterations=4"
0.847334 20.1503 "passes=6 iterations=4"
END
$curve11 << END
0.882076 11.3185 "passes=3 substeps=2"
1.73758 5.11548 "passes=3 substeps=4"
3.506 2.60719 "passes=3 substeps=8"
END
$curve12 << END
0.108646 896.496 "substeps=1"
0.208106 793.578 "substeps=2"
0.40984 603.442 "substeps=4"
0.81196 343.057 "substeps=8"
1.63405 142.955 "substeps=16"
3.26307 70.5963 "substeps=32"
6.49249 35.6026 "substeps=64"
END
$curve13 << END
0.328626 791.941 "iterations=4"
1.1943 571.553 "iterations=16"
4.72639 291.08 "iterations=64"
END
$curve14 << END
0.343851 744.764 "iterations=4"
1.19404 496.065 "iterations=16"
4.51877 216.308 "iterations=64"
END
$curve15 << END
1.68889 91.2229 "iterations=1 substeps=16"
6.81667 15.3896 "iterations=1 substeps=64"
END
$curve16 << END
5.72069 0.754771 "substeps=213"
8.79084 0.728562 "substeps=328"
17.4419 0.823754 "substeps=655"
END
$curve17 << END
10.7062 11.8022 "substeps=213"
32.4487 1.98361 "substeps=655"
END
$curve18 << END
201.953 82.1748 "one factorisation a step"
END
$default << END
0.41763 40.9277 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-64-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  38.9164 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.0102 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-64-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  38.9164 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.0102 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
