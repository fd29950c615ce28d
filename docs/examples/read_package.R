# Heights of a Sightline package by target, with base R: Rscript read_package.R FOLDER
#
# Prints CSV: for each target the accepted heights, their percentiles (type 8, as Sightline's own) in metres, and the
# median of their U95. Only accepted heights count: those that a reviewer accepted or fixed and nobody withdrew.

folder <- commandArgs(trailingOnly = TRUE)[1]
read <- function(name) {
  read.csv(file.path(folder, "tables", name), na.strings = "", encoding = "UTF-8", check.names = FALSE)
}

heights <- read("measurements.csv")
vehicles <- read("vehicles.csv")[, c("id", "category")]
heights <- merge(heights, vehicles, by.x = "vehicle_id", by.y = "id")
accepted <- heights[
  heights$verdict %in% c("accepted", "fixed") & heights$status == "ok" & heights$withdrawn == "false",
]

cat("target,count,p15_m,p50_m,p85_m,median_U95_m\n")
for (target in sort(unique(accepted$target))) {
  group <- accepted[accepted$target == target, ]
  at <- quantile(group$height_m, c(0.15, 0.5, 0.85), type = 8, names = FALSE)
  figures <- c(at, median(group$U95_height_m))
  cat(target, nrow(group), sprintf("%.4f", figures), sep = ",")
  cat("\n")
}
