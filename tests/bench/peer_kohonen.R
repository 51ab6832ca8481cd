# peer_kohonen.R ITEM SIZE: R's kohonen (Wehrens and Kruisselbrink) on the same kind of input: a flat map of 27 x 27 = 729 units, as near to 724
# classes as a square comes, on the sphere of 7082 points; four epochs, the time scaled to 30000 steps. Prints `VERSION SECONDS QE`.
if (!suppressWarnings(suppressMessages(require(kohonen, quietly = TRUE)))) quit(status = 1)
r <- rep(1:59, each = 120)
s <- rep(0:119, 59)
x <- rbind(c(0.5, 1, 0.5),
           cbind(0.5 - 0.5 * sin(pi * r / 60) * sin(2 * pi * s / 120), 0.5 + 0.5 * cos(pi * r / 60),
                 0.5 - 0.5 * sin(pi * r / 60) * cos(2 * pi * s / 120)),
           c(0.5, 0, 0.5))
set.seed(1)
epochs <- 4
best <- Inf
for (run in 1:3) {
    took <- system.time(map <- som(x, grid = somgrid(27, 27, "rectangular"), rlen = epochs, alpha = c(0.9, 0.09), radius = c(10, 1), mode = "online"))
    best <- min(best, took[["user.self"]] + took[["sys.self"]])
}
# one write: the reader may leave after the third number
cat(sprintf("%s %.9g %.9g\n", as.character(packageVersion("kohonen")), best * 30000 / (epochs * nrow(x)), mean(sqrt(map$distances))))
