# The guest's part of check-linux, on tty1 as its controlling terminal; results
# go to /mnt/manifest and, as lines with FAIL, to the serial line.
cd /mnt || exit 2
read -r row < row
scenes="/mnt/scenes/*.pel /mnt/reference.pel"
. /mnt/guest.sh
. /mnt/guest_rows.sh
: > manifest
"row_$row"
echo "$row: $failures failures"
[ $failures -eq 0 ]
