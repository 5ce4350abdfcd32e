# Called by scene_chart.sh with `data`, a folder, and `png`, the picture's name.
set terminal pngcairo size 1100,500 font "sans,11"
set output png
set logscale xy
set ylabel "ms a picture"
set grid x y linetype 1 linewidth 0.5 linecolor rgb "#cccccc"
set key top left
set border 3
set tics nomirror
set format x "10^{%L}"
set multiplot layout 1,2
set title "Triangles, 1024 x 1024 pixels"
set xlabel "triangles of a ring"
plot for [mode in "flat gouraud phong"] data."/triangles_".mode \
    with linespoints pointtype 7 linewidth 1.5 title mode
set title "Pixels, 20,000 triangles"
set xlabel "pixels of the picture"
plot for [mode in "flat gouraud phong"] data."/pixels_".mode \
    with linespoints pointtype 7 linewidth 1.5 title mode
unset multiplot
