# Called by speed_chart.sh with `data`, a folder, and `png`, the picture's name.
set terminal pngcairo size 1100,1100 font "sans,11"
set output png
set title "Nanoseconds per pixel: Pel, memset and peers (less is better)"
set logscale x
set xlabel "ns per pixel, median"
set xrange [0.02:*]
set grid x y linetype 1 linewidth 0.5 linecolor rgb "#cccccc"
set key outside right top
set border 3
set tics nomirror
rows = int(system("wc -l < ".data."/names"))
set yrange [rows + 0.5:0.5]
set for [i=1:rows] ytics add (system(sprintf("sed -n '%ds/.* //p' %s/names", \
    i, data)) i)
has(name) = system("test -f ".data."/".name." && echo 1") eq "1"
files = ""
titles = ""
colors = ""
types = ""
do for [s in "memset:memset:#000000:1 \
pel_gcc_-O2:Pel,_gcc_-O2:#0055cc:7 pel_clang_-O2:Pel,_clang_-O2:#0055cc:6 \
pel_gcc_-native:Pel,_gcc_native:#33aadd:7 \
pel_clang_-native:Pel,_clang_native:#33aadd:6 \
allegro4:Allegro_4:#dd7700:5 sdl2:SDL2:#228833:9 cairo:cairo:#cc2222:13 \
qt5:Qt_5:#8844aa:11 osmesa:OSMesa:#996633:1 agg:AGG:#cc66aa:2"] {
    name = system("echo ".s." | cut -d: -f1")
    if (has(name)) {
        files = files." ".name
        titles = titles." ".system("echo ".s." | cut -d: -f2")
        colors = colors." ".system("echo '".s."' | cut -d: -f3")
        types = types." ".system("echo ".s." | cut -d: -f4")
    }
}
plot for [i=1:words(files)] data."/".word(files, i) using 2:1 with points \
    pointtype int(word(types, i)) pointsize 1.4 linewidth 1.5 \
    linecolor rgb word(colors, i) title system("echo ".word(titles, i). \
    " | tr _ ' '")
