# What all charts share. Curves differ in their points and dashes, not in colours
# alone; the colours are those of Okabe and Ito, and the shades of cells grow
# darker with the value, in grey too.
set datafile separator "\t"
set encoding utf8
set border 3 back
set tics nomirror back
set grid x y linetype 1 linewidth 0.4 linecolor rgb "#d8d8d8"
set key outside right top noenhanced font ",9" samplen 3
set xlabel noenhanced
set ylabel noenhanced
unset colorbox
set pointintervalbox 0
set palette defined (0 "#fffde0", 0.25 "#f3cf72", 0.5 "#c98a3c", 0.75 "#7a4a5c", 1 "#1c1c3c")
types = "7 5 9 11 13 4 6 8 10 12 1 2 3 15"
colors = "#000000 #0072b2 #d55e00 #009e73 #cc79a7 #e69f00 #56b4e9 #7a7a00 #555555 #8844aa #996633 #444488 #bb4466 #2a5c3a"
dashes(i) = (i - 1) % 5 + 1
do for [i=1:36] {
    set linetype i pointtype int(word(types, (i - 1) % 14 + 1)) \
        linecolor rgb word(colors, (i - 1) % 14 + 1) pointsize 0.9 \
        linewidth (i == 1 ? 2.2 : 1.3) dashtype dashes(i)
}
