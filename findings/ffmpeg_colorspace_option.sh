#!/usr/bin/env bash
# ffmpeg: "-colorspace bt709" for a film made of raw RGB pictures is a label in 5.1 and a conversion in 7.1, and a film by
# the mpeg4 encoder has no such label: with 5.1 libx264's films have wrong colours, with 7.1 mpeg4's have.
#
# One would guess that the option either names the matrix by which the pictures are converted, or labels the result, in all
# versions and for all encoders. But 5.1 converts by BT.601 whatever the option says and lets libx264 write bt709; 7.1 and
# 9.0.2 convert by BT.709, and mpeg4's file does not say so, which ffmpeg itself then reads as BT.601. A game that films
# itself gets its reds too bright or too dark by 12 or 13 of 255, depending on the machine. It helps to leave the colours of
# mpeg4 alone, and to give libx264 both "-vf scale=out_color_matrix=bt709:out_range=tv" and the option: right in all three.
#
# Runs with the ffmpeg of Debian 12 or of Debian 13.
# Exit status: 0 as described, 1 it behaves otherwise now, 2 the packages cannot be had.
set -u
version="$(dpkg-query -W -f '${Version}' ffmpeg 2>/dev/null)"
case "$version" in
  7:5.1.9-0+deb12u1)
    expected='libx264, no option: unknown, 200 58 29
libx264, -colorspace bt709: bt709, 212 70 26
libx264, filter and option: bt709, 199 58 29
mpeg4, no option: unknown, 200 58 29
mpeg4, -colorspace bt709: unknown, 200 58 29'
    ;;
  7:7.1.5-0+deb13u1)
    expected='libx264, no option: unknown, 200 58 29
libx264, -colorspace bt709: bt709, 199 58 29
libx264, filter and option: bt709, 199 58 29
mpeg4, no option: unknown, 200 58 29
mpeg4, -colorspace bt709: unknown, 187 45 32'
    ;;
  *)
    echo "Neither ffmpeg 7:5.1.9-0+deb12u1 nor 7:7.1.5-0+deb13u1 is installed." >&2
    exit 2
    ;;
esac
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 2

# film NAME ENCODER OPTION...: the matrix that the file names, and the colour of its first pixel when decoded.
film() {
  local name="$1" encoder="$2" matrix bytes
  shift 2
  ffmpeg -v error -y -f rawvideo -pix_fmt rgb24 -s 64x64 -r 5 -i pictures -c:v "$encoder" "$@" -pix_fmt yuv420p film.mp4 ||
    exit 2
  matrix="$(ffprobe -v error -show_entries stream=color_space -of csv=p=0 film.mp4)"
  bytes="$(ffmpeg -v error -i film.mp4 -frames:v 1 -f rawvideo -pix_fmt rgb24 - | od -An -tu1 -N3)"
  local red green blue
  read -r red green blue <<<"$bytes"
  echo "$encoder, $name: $matrix, $red $green $blue"
}
printf '\310\074\036%.0s' $(seq $((64 * 64 * 5))) >pictures  # five pictures of 200 60 30
seen="$(
  filter=scale=out_color_matrix=bt709:out_range=tv
  film 'no option' libx264
  film '-colorspace bt709' libx264 -colorspace bt709
  film 'filter and option' libx264 -vf "$filter" -colorspace bt709
  film 'no option' mpeg4
  film '-colorspace bt709' mpeg4 -colorspace bt709
)" || exit 2
echo "ffmpeg $version, pictures of the colour 200 60 30, the matrix named in the film and the colour decoded from it:"
echo "$seen"
[[ "$seen" == "$expected" ]]
