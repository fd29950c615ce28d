# What Sightline says, in English: screens, errors, notes, report and command line. The language of the source;
# other languages are files beside this one. Keys are kebab-case, `area-what`; values carry their unit in their
# name. Marked parts: <strong>, <em>, <kbd>, <code>, <sub>, and those that a screen gives a meaning (<link>).


## Words of the domain: targets, and where to click each

target-roof = Roof
target-driver_eye = Driver's eye
target-taillight = Taillight
target-headlight = Headlight
target-other = Other
target-hint-roof = the highest point of the roof
target-hint-driver_eye = the driver's eye
target-hint-taillight = the lower limit of the lit area of the taillight
target-hint-headlight = the lower limit of the headlight
target-hint-other = the point whose height you want

## Words of the domain: states of vehicles, measurements, recordings, jobs, calibrations, people

state-to_do = to do
state-partial = partly measured
state-measured = measured
state-to_review = to review
state-accepted = accepted
state-fixed = fixed
state-rejected = rejected
state-reopened = reopened
state-withdrawn = withdrawn
state-not_measurable = not measurable
state-done = done
state-next = next
state-waiting = waiting
state-ingesting = being read
state-ready = ready
state-failed = failed
state-queued = queued
state-running = running
state-cancelled = cancelled
state-trusted = trusted
state-not_trusted = not to be trusted
state-used = used
state-left_out = left out
state-active = active
state-inactive = switched off

## Words of the domain: light and kinds of vehicles

lighting-daytime = Daytime
lighting-low_light = Low light
category-hatchback = Hatchback
category-saloon = Saloon
category-estate = Estate
category-suv = SUV
category-van = Van
category-lorry = Lorry
category-other = Other

## Roles of people

role-viewer = Viewer
role-operator = Operator
role-reviewer = Reviewer
role-admin = Administrator

## Pages: their names in the rail, the window's title and links

page-sign-in = Sign in
page-surveys = Surveys
page-survey = Overview
page-planning = Plan the site
page-camera = Camera
page-recordings = Recordings
page-pose = Road pose
page-measure = Measure
page-checks = Checks
page-review = Review
page-repeats = Repeats
page-click-again = Click again
page-scans = Line scans
page-scan-results = Motion
page-scan = Line scan
page-export = Export
page-statistics = Statistics
page-audit = Audit
page-people = People
page-account = Account

## Commands: buttons, menus and the list of keys

command-help = Show the keys
command-frameNext = Next frame
command-framePrevious = Previous frame
command-frameNextTen = Ten frames on
command-framePreviousTen = Ten frames back
command-secondNext = One second on
command-secondPrevious = One second back
command-frameFirst = First frame
command-frameLast = Last frame
command-frameGo = Go to a frame
command-play = Play and stop
command-loupe = Loupe, while held
command-loupeToggle = Loupe on and off
command-linesToggle = Hide and show the lines
command-brightToggle = Brighten the picture, for display only
command-cursor = Place points by keyboard: cursor on and off
command-place = Place the point at the cursor
command-zoomIn = Zoom in
command-zoomOut = Zoom out
command-zoomFit = Fit the frame
command-passNext = Next pass
command-passPrevious = Previous pass
command-target1 = Target: roof
command-target2 = Target: driver's eye
command-target3 = Target: taillight
command-target4 = Target: headlight
command-target5 = Target: other
command-newContact = New contact point
command-secondFrame = Second frame: click the same two points there
command-proposeContact = Propose the tyre's contact at the pointer
command-selectNext = Select the next point
command-bestFrame = Best frame of the pass
command-passBegin = Mark the first frame of a pass or the board
command-passEnd = Mark the last frame of a pass or the board
command-passSplit = Split the pass before this frame
command-passJoin = Join the pass with the next one
command-passDiscard = Discard the pass
command-confirmNext = Confirm and go to the next pass
command-undo = Undo
command-redo = Redo
command-remove = Withdraw the selected measurement
command-cancel = Let go of the point, close
command-nudgeLeft = Move the point left 1 px
command-nudgeRight = Move the point right 1 px
command-nudgeUp = Move the point up 1 px
command-nudgeDown = Move the point down 1 px
command-nudgeLeftFar = Move the point left 10 px
command-nudgeRightFar = Move the point right 10 px
command-nudgeUpFar = Move the point up 10 px
command-nudgeDownFar = Move the point down 10 px
command-nudgeLeftFine = Move the point left 0.1 px
command-nudgeRightFine = Move the point right 0.1 px
command-nudgeUpFine = Move the point up 0.1 px
command-nudgeDownFine = Move the point down 0.1 px
command-scanFit = Fill the window with the vehicle
command-scanTaller = Stretch the height
command-scanFlatter = Flatten the height
command-scanWheels = Click both wheels for the wheelbase
command-scanNew = Add a vehicle by its front and rear
command-scanHeight = Measure heights by contact and target
command-scanRod = Calibrate the height with a rod
command-reviewAccept = Accept
command-reviewReject = Reject
command-reviewFix = Fix
command-reviewNext = Next measurement
command-reviewPrevious = Previous measurement

## Where keys listen

scope-anywhere = Everywhere
scope-frames = Frames
scope-measure = Measure
scope-point = A selected point
scope-scan = Line scan
scope-review = Review

## Times, lengths, and what went wrong

time-just-now = just now
time-minutes-ago = { $minutes } min ago
time-today = today { $time }
length-problem = A length, such as { $example }.
problem-server = The server could not do this (status { $status }); try again, and tell the administrator if it stays.
problem-refused = The server refused this (status { $status }).
problem-stopped = This was stopped.
problem-page = Something went wrong in this page; reload it, and tell the administrator if it happens again.
problem-offline = The server cannot be reached.
keys-reserved = The browser keeps { $chord } for itself; choose another key.

## Components: progress, undo

loading = Loading { $what }…
job-queued = Waiting for its turn
job-working = Working
undo-step = Undo: { $step }
undo-nothing = Nothing to undo
redo-step = Redo: { $step }
redo-nothing = Nothing to redo

## App: titles, the bar above, the rail, addresses that lead nowhere

app-name = Sightline
app-title = { $page } – Sightline
app-title-in-survey = { $page } – { $survey } – Sightline
app-not-found = Not found
app-skip = Skip to the page
app-to-surveys = Go to the surveys
app-nothing-here-title = There is nothing at this address
app-nothing-here = The link may be old, or the survey may have been removed.
app-not-loaded = This page could not be loaded, perhaps because a newer version was installed; reload it.
app-loading-page = { $page ->
    [sign-in] sign in
    [surveys] surveys
    [survey] overview
    [planning] plan the site
    [camera] camera
    [recordings] recordings
    [pose] road pose
    [measure] measure
    [checks] checks
    [review] review
    [repeats] repeats
    [click-again] click again
    [scans] line scans
    [scan-results] motion
    [scan] line scan
    [export] export
    [statistics] statistics
    [audit] audit
    [people] people
   *[account] account
}
app-where = Where you are
app-survey = Survey
app-other-step = { $page }: go to another step
app-keys = Keys
app-work = Order of work
app-audit = Audit trail
save-waiting = { $count } not yet saved
save-pending = saving…
save-failed = last change not saved
save-done = saved { $time }
menu-person = { $person }: account and settings
menu-role = { $role } · Sightline { $version }
menu-theme = Theme
menu-theme-system = System
menu-theme-light = Light
menu-theme-dark = Dark
menu-lengths = Lengths
menu-lengths-metres = Metres
menu-lengths-feet = Feet
menu-sign-out = Sign out

## App: while the server cannot be reached

offline-kept = { $count ->
    [one] { $count } change is kept in this browser and will be saved when it is back.
   *[other] { $count } changes are kept in this browser and will be saved when it is back.
}
offline-changes = { $count ->
    [one] { $count } change will be saved when it is back; keep this page open.
   *[other] { $count } changes will be saved when it is back; keep this page open.
}
offline-next = Next try in { $seconds } s.
offline-now = Trying again…
offline-try = Try now

## App: what was refused, or changed by somebody else meanwhile

unsaved-refused = { $problem } Yours: { $mine }.
unsaved-conflict = { $problem } Yours: { $mine }. Theirs: { $theirs }.
unsaved-take = Take theirs
unsaved-keep = Keep mine
unsaved-again = Try again
unsaved-drop = Let it go
unsaved-otherwise = The server stored something else than was asked for; look at it again.

## App: the list of keys

keys-usual = Back to the usual keys
keys-clash = { $chord } now means both “{ $one }” and “{ $other }”; the first one wins.
keys-elsewhere = On other screens
keys-wheel = Wheel: zoom at the pointer. Drag with the middle button, or with Space held: move the picture.
keys-of = { $command }: { $keys }. Change
keys-change = Change the key
keys-press = press a key…

## Boards: the kind of a board and its markers

board-kind = Kind of board
board-checkerboard = Checkerboard
board-charuco = ChArUco
board-dictionary = Dictionary
board-marker = Marker’s side
board-marker-problem = Give the side of the black marker, for example { $example }.
board-marker-too-large = A marker is smaller than its square.

## Did the camera move

drift-title = Did the camera move?
drift-stopped = The check stopped.
drift-under-way = Whether the camera moved since its road pose is being looked at.
drift-not-yet = Whether the camera moved since its road pose has not been looked at.
drift-holds = Still good, says { $person }: { $reason }
drift-over-time = Over the recording's time
drift-again = Look again
drift-take-back = Take the decision back
drift-reason = The pose is still good, because
drift-decide = Decide: still good
drift-look = frame { $frame }: { $moved_px } px, { $change }
drift-figure = { $untold ->
    [0] { $count } frames against the road pose's; worst { $worst } of height for a target { $target } high at { $distance }. The band is what could not be told from standing still.
   *[other] { $count } frames against the road pose's, { $untold } told nothing; worst { $worst } of height for a target { $target } high at { $distance }. The band is what could not be told from standing still.
}

## Figures: their downloads and marks

figure-as-svg = { $figure } as SVG
figure-as-csv = { $figure } as CSV
figure-standard = { $standards } { $height } { $unit }

## Vehicles: budget, history, catalogue, passes

budget-title = Where the uncertainty comes from
budget-note = standard uncertainty
budget-together = together
revisions-title = History
revisions-who = { $person }, { $time }
revisions-review = { $person } – { $reason }
catalogue-list = { $field } in the catalogue
passes-find = Find the passes
passes-find-title = Looks through the video for vehicles; passes that are there or were discarded stay as they are
passes-failed = The search failed; try it again.
passes-cancelled = The search for passes in { $recording } was cancelled.
passes-found = { $recording }: { $message }
passes-over = { $recording }: the search is over.
passes-all = All
passes-to-do = To do
passes-rejected = Rejected
passes-measured = Measured
passes-by-number = by number
passes-by-time = by time
passes-by-state = by state

## The picture: frame, loupe, timeline, transport

viewer-frame = frame { $frame }
viewer-frame-label = Frame { $frame }
viewer-frame-at = frame { $frame }, { $time }
viewer-stand-in = thumbnail of frame { $thumbnail }; frame { $frame } is coming
viewer-what = frame
viewer-layers = Axes and points over the picture
viewer-bright = display only: brightened
viewer-pointer = x { $x } y { $y }
viewer-wrong-frame = The server sent frame { $served } for frame { $frame }, so it is not shown; ingest the recording again.
viewer-slid = Nothing was placed: the pointer moved on while the button was down. Space and a drag move the picture.
viewer-changed = Nothing was placed: another picture came while the button was down. Click again.
viewer-first-corner = first
timeline-label = Position in the recording
timeline-decoded = Decoded on the server
transport-play = Play
transport-stop = Stop
transport-frame = frame
transport-of = of { $last_frame }
transport-vfr-title = The frame rate of this recording varies; times come from each frame's own stamp.
blind-elsewhere = Another frame than the one to click on; that is { $frame }.
blind-contact = click where the tyre meets the road
blind-target = { $target ->
    [roof] click { target-hint-roof }
    [driver_eye] click { target-hint-driver_eye }
    [taillight] click { target-hint-taillight }
    [headlight] click { target-hint-headlight }
   *[other] click { target-hint-other }
}
blind-wrong-frame = Click on frame { $frame }, where the first clicks are.

## Camera: the page

camera-lead = A body and lens at one setting of zoom and focus. Calibrating it tells how the lens bends the picture, and how well that is known.
camera-another = Another camera
camera-loading-all = cameras
camera-loading = the camera
camera-none-title = No camera yet
camera-none = Name the camera that filmed this site. Then drop in some fifteen pictures of a checkerboard, taken with it at the same zoom and focus, or a file with its calibration from another tool.
camera-add-first = Add the camera
camera-list = Cameras
camera-add = Add a camera
camera-name = Camera { $number }
camera-name-problem = A camera needs a name.
camera-notes-hint = Body, lens, zoom and focus setting: what must stay the same for the calibration to hold.

## Camera: calibrating

camera-calibrate = Calibrate
camera-calibrate-again = Calibrate again
camera-where-boards = Where the boards are
camera-from-pictures = From pictures
camera-from-recording = From a recording
camera-choose-pictures = Choose pictures of the checkerboard
camera-drop-pictures = Drop pictures of the checkerboard here, or click to choose
camera-drop-hint = Same camera, same zoom and focus. Tilt the board, bring it into every corner, keep it sharp.
camera-found-in = { $count ->
    [one] The board was found in <strong>{ $found }</strong> of { $count } image.
   *[other] The board was found in <strong>{ $found }</strong> of { $count } images.
}
camera-too-few = At least three are needed; twelve to twenty from different sides give a good calibration.
camera-more-better = That will do; twelve to twenty, with the board tilted and in every corner of the picture, do better.
camera-other-board = The images were searched for another board; look again for { $columns } × { $rows } inner corners.
camera-other-board-markers = The images were searched for another board; look again for { $columns } × { $rows } inner corners and markers of { $dictionary }.
camera-look-again = Look again
camera-to-go = { $count ->
    [one] { $count } image to go
   *[other] { $count } images to go
}
camera-import = Import a calibration file
camera-import-title = OpenCV YAML or JSON, ROS camera_info, Kalibr, mrcal
camera-imported = { $file } was read.
camera-failed = The calibration failed; try again.
camera-recording-frames = { $count ->
    [one] { $recording } ({ $count } frame)
   *[other] { $recording } ({ $count } frames)
}
camera-every = Every n-th frame
camera-first-frame = First frame
camera-last-frame = Last frame
camera-no-recording = No recording is ready; <link>bring in the clip</link> in which the board is moved about.
camera-every-problem = Take every n-th frame, with n a whole number from 1.
camera-frames-problem = Give the first and last frame as whole numbers.
camera-frames-order = The last frame lies before the first.
camera-frames-end = The recording ends with frame { $last_frame }.
camera-lens = Lens
camera-lens-brown = Ordinary lens
camera-lens-fisheye = Fisheye
camera-lens-brown-hint = Pinhole with Brown distortion: up to about 100° of view.
camera-lens-fisheye-hint = Equidistant with four terms: for lenses that see more than about 100°.
camera-board = Board
camera-board-flat = Flat board
camera-board-bent = May be bent
camera-board-flat-hint = On a stiff plate. The result says how flat it was.
camera-board-bent-hint = Paper on a wall or thin sheet: its shape is solved for too. Needs six views, better 15.
camera-three-images = Three images with the board are the least; the button wakes up then.
camera-corners-found = { $count ->
    [one] { $count } corner found in { $image }
   *[other] { $count } corners found in { $image }
}
camera-remove = Remove { $image }
camera-found-some = { $found } of { $all } found
camera-found-all = { $columns } × { $rows } found

## Camera: the board

camera-inner-corners = Count the <strong>inner corners</strong>: the points where four squares meet. A board of 10 by 7 squares has 9 by 6.
camera-charuco-corners = Makers of ChArUco boards often state the squares: one less each way. Part of the board in a picture is enough.
camera-columns = Columns
camera-rows = Rows
camera-square = Side of one square
camera-square-hint = Measure across ten squares with a ruler and divide by ten: printers rarely keep the size.
camera-square-problem = { $unit ->
    [ft] Give the side of one square in inches, for example { $example }.
   *[m] Give the side of one square in millimetres, for example { $example }.
}
camera-count-problem = { $what ->
    [rows] Give the number of rows as a whole number.
   *[columns] Give the number of columns as a whole number.
}
camera-count-range = { $what ->
    [rows] Between 3 and 50 rows can be found; count the inner corners again.
   *[columns] Between 3 and 50 columns can be found; count the inner corners again.
}
camera-drawing = { $kind ->
    [charuco] A ChArUco board, markers in its white squares, with { $columns } inner corners across and { $rows } down: the points where four squares meet. The outer edge does not count.
   *[checkerboard] A board with { $columns } inner corners across and { $rows } down: the points where four squares meet. The outer edge does not count.
}
camera-drawing-columns = { $count ->
    [one] { $count } column
   *[other] { $count } columns
}
camera-drawing-rows = { $count ->
    [one] { $count } row
   *[other] { $count } rows
}
camera-drawing-square = square { $side }

## Camera: a calibration

camera-calibrations = Calibrations
camera-loading-calibration = the calibration
camera-trusted = This calibration can be trusted
camera-not-trusted = This calibration is not to be trusted
camera-made = { $source ->
    [import] Imported { $time }
    [clip] From a recording { $time }
   *[images] From images { $time }
}
camera-made-by = { $source ->
    [import] Imported { $time }, { $person }
    [clip] From a recording { $time }, { $person }
   *[images] From images { $time }, { $person }
}
camera-use = Use this one
camera-residual = residual (rms)
camera-not-told = not told
camera-views-used = { $count ->
    [one] { $used } of { $count } view used
   *[other] { $used } of { $count } views used
}
camera-picture = picture
camera-across = { $model ->
    [fisheye] fisheye, about { $angle }° across
   *[brown] ordinary lens, about { $angle }° across
}
camera-u = ± { $u }
camera-u-note = ± is one standard uncertainty (k = 1).
camera-fx = focal length, across
camera-fy = focal length, down
camera-cx = optical centre, across
camera-cy = optical centre, down
camera-distortion = distortion { $name }
camera-coverage-unknown = Which parts of the picture the boards covered is not known for this calibration.
camera-coverage = Where corners were seen: { $percent } % of the picture.
camera-coverage-label = Coverage of the picture: { $empty } of { $all } parts hold no corner
camera-coverage-cell = { $count ->
    [one] { $count } corner
   *[other] { $count } corners
}
camera-covered = Every part of the picture was covered well enough.
camera-reshoot = What to shoot again
camera-residuals = Residual of each view
camera-left-out = { $count ->
    [one] { $count } view left out
   *[other] { $count } views left out
}
camera-no-reason = no reason told
camera-residuals-label = Residuals of { $file }, the longest { $longest_px } pixels
camera-worst-view = Worst view.
camera-residuals-drawn = { $file }: residuals drawn { $times } times as long; the longest is { $longest_px } px.
camera-history-made = made
camera-history-by = by
camera-history-from = from
camera-history-verdict = verdict
camera-history-summary = summary
camera-history-show = show
camera-history-shown = shown
camera-show = Show
camera-source-images = images
camera-source-clip = a recording
camera-source-import = a file

## Camera: the checks of a calibration

camera-checks = Checks
camera-halves = Two halves, calibrated apart
camera-halves-not-done = Not done. { $reason }
camera-halves-nothing = The picture shows too little of such a scene to compare a height.
camera-halves-differ = Two halves of the pictures, calibrated apart, differ by { $differences } in a height.
camera-difference-at = { $difference } at { $distance }
camera-held-out = Residual of pictures that did not help to find the lens: { $held_out }; of those that did: { $fit }.
camera-under = under { $length }
camera-vehicle-at = vehicle at
camera-heights-differ = heights differ by
camera-expected = expected (k = 1)
camera-not-in-picture = not in the picture
camera-halves-note = An eye at { $eye }, camera level at { $camera }, board at { $board }, the same clicks through either half. Expected is what the noise of the corners alone would make.
camera-flatness = Flatness of the board
camera-board-solved = Solved for: the board bends by { $bow }; taken as flat the residual is { $flat }, with its shape solved for { $bent }.
camera-board-taken-flat = Taken as flat. From the pictures it bends by { $bow }; taken as flat the residual is { $flat }, with its shape solved for { $bent }.

## Road pose: the page

pose-loading = the road pose
pose-no-recording-title = No recording with the board yet
pose-no-recording = Add the video in which the checkerboard stands on the road; the road pose is found from it.
pose-add-recordings = Add recordings
pose-mark-first = Mark the first frame of the board
pose-mark-last = Mark the last frame of the board
pose-side = Board and result
pose-board-span = Board: frames { $first_frame } to { $last_frame }
pose-go-again = This recording has its road pose. To find it again, go to a frame in which the board stands still.
pose-go = Go to a frame in which the board stands still.
pose-looking = Looking for the board…
pose-found-part = Part found
pose-found = { $columns } × { $rows } found
pose-chosen = This pose now holds for the recording; heights clicked from now on use it.

## Road pose: the questions

pose-lens = Recording and lens
pose-calibration-none = none yet
pose-calibration = { $state ->
    [current] { $camera }, { $calibration }, current
    [current_not_trusted] { $camera }, { $calibration }, current, not to be trusted
    [not_trusted] { $camera }, { $calibration }, not to be trusted
   *[other] { $camera }, { $calibration }
}
pose-board = The board
pose-columns = Inner corners across
pose-rows = and down
pose-square = Square
pose-corners-hint = Inner corners are where four squares meet: a board of 10 by 7 squares has 9 by 6.
pose-charuco-hint = A road pose needs the whole board in sight.
pose-still = Frames in which it stands still
pose-begins = Begins here
pose-begins-title = The first frame
pose-ends = Ends here
pose-ends-title = The last frame
pose-not-marked = not marked yet
pose-end-not-marked = from { $first_frame }, end not marked
pose-marked = { $count ->
    [one] { $first_frame } to { $last_frame }, { $count } frame
   *[other] { $first_frame } to { $last_frame }, { $count } frames
}
pose-height = How high it stands
pose-reference = Reference row
pose-reference-bottom = lowest row of corners
pose-reference-top = uppermost row
pose-reference-height = { $reference ->
    [top] From the road up to the uppermost row of inner corners
   *[bottom] From the road up to the lowest row of inner corners
}
pose-drawing = { $reference ->
    [top] The tape runs from the road up to the uppermost row of inner corners.
   *[bottom] The tape runs from the road up to the lowest row of inner corners.
}
pose-drawing-tape = tape
pose-drawing-road = road
pose-sure = How sure these are
pose-u-tape = ± of the tape
pose-u-lean = ± of the lean
pose-u-square = ± of a square
pose-u-bow = ± of the bow
pose-u-hint = Standard uncertainties, all estimates until you measure them: 3 mm is a steel tape read with care on asphalt; 0.3° is a board set with a good spirit level, towards the camera and sideways alike; a print is true to 0.1 % of a square; the middle of a stiff board is out of plane by 0.5 mm. Each goes into every height's budget under its own name.
pose-find = Find the road pose
pose-find-again = Find the road pose again
pose-stopped = Stopped; nothing was changed.
pose-look-only = You may look; an operator finds the pose.
pose-problem-calibration = Calibrate the camera first; without its lens there is no pose.
pose-problem-board = A board has at least 2 by 2 inner corners.
pose-problem-square = Measure one square over several and enter its side.
pose-problem-height = Measure it with a tape; every height rests on it.
pose-problem-u = Each is a figure of zero or more.
pose-problem-span = Mark the frames in which the board stands still.

## Road pose: the result

pose-result = The recording's road pose
pose-result-earlier = An earlier road pose
pose-use = Use this pose for the recording
pose-measure = Measure with it
pose-expected = Expected uncertainty of a height
pose-expected-distance = at a distance of
pose-expected-good = a height is good to (95 %)
pose-expected-U95 = ± { $U95 }
pose-expected-reason = At { $distance }: { $reason }
pose-facts = Frames { $first_frame } to { $last_frame }; corners fit to { $fit }; board at { $distance }.
pose-other-recording = another recording
pose-poses = { $count ->
    [one] { $count } pose in this survey
   *[other] { $count } poses in this survey
}
pose-made = { $time }, frames { $first_frame } to { $last_frame }
pose-use-short = Use

## Recordings

recordings-lead = Every frame is numbered by the server as it decodes the file, so frame n is the same picture for everybody.
recordings-loading = recordings
recordings-choose = Choose videos to upload
recordings-drop = Drop videos here, or click to choose
recordings-drop-hint = A broken connection does no harm: the upload goes on where it stopped, also after this page was closed.
recordings-uploads = Uploads
recordings-none-title = No recordings yet
recordings-none = Drop the day's video above: MP4, MOV, AVI, MKV and what else a camera writes. The clip in which the checkerboard stands on the road counts too: the road pose is found in it.
recordings-none-look = An operator can upload the day's video here.
recordings-delete-title = Delete { $recording }?
recordings-delete-body = The video, its frame table and its road poses go; a recording with measurements cannot be deleted.
recordings-delete = Delete the recording
recordings-delete-one = Delete { $recording }
recordings-deleted = { $recording } was deleted.
recordings-vfr-title = Variable frame rate: times come from each frame's own time stamp
recordings-find-road = Find the road
recordings-measure = Measure
recordings-read-again = Read it again
recordings-unreadable = This recording could not be read.
recordings-no-picture = no picture
recordings-no-picture-yet = no picture yet
recordings-rename = Rename
recordings-rename-one = Rename { $recording }
recordings-name = Name of the recording
recordings-frames = { $count ->
    [one] { $count } frame
   *[other] { $count } frames
}
recordings-rate = { $rate } per second
recordings-rate-average = { $rate } per second on average
recordings-codec = { $codec } in { $container }
recordings-sha256 = SHA-256 { $sha256 }
recordings-no-camera = No camera yet: <link>calibrate one</link>.
recordings-camera = Camera
recordings-camera-unsaid = not said yet
recordings-camera-uncalibrated = { $camera } (not calibrated)
recordings-lighting = Lighting
recordings-lighting-proposed = Lighting <muted>(proposed)</muted>
recordings-lighting-of = Lighting of { $recording }
recordings-lighting-of-proposed = Lighting of { $recording }, proposed by the machine
recordings-lighting-guess = { $lighting } ?

## Words that many pages need

interval = { $low } to { $high }
person-system = the system
person-unknown = unknown
menu-language = Language
stage-frame = Frame
stage-frames = Frames
stage-timeline = Timeline
stage-fit = Fit
stage-lines = Lines
stage-bright = Bright
stage-loupe = Loupe
vfr = VFR
field-name = Name
field-recording = Recording
field-calibration = Calibration
in-use = in use
field-notes = Notes
action-add = Add
action-cancel = Cancel
action-close = Close
action-dismiss = Dismiss
action-keep = Keep it
action-save = Save
action-try-again = Try again
action-clear-filter = Clear the filter
action-print = Print
file-csv = CSV
figure-share-of-vehicles = share of vehicles (%)
with-unit = { $name } ({ $unit })
percent = { $percent } %
value-px = { $value } px
value-s = { $value } s
file-svg = SVG
unit-px = px
unit-hz = Hz

## Repeats: the page

repeats-lead = The same targets clicked again without seeing the first clicks: how far a person comes out beside themselves, and how far two people beside each other.
repeats-loading = the repeats
repeats-not-compared = { $count ->
    [one] { $count } repeat
   *[other] { $count } repeats
} with another road pose or inset, or without a height: in none of these figures.
repeats-click-mine = Click 10 of mine again
repeats-click-anybodys = Click 10 of anybody’s again
repeats-none-title = Nothing was clicked again yet
repeats-none = Repeats come from two places: click a random ten again here, each without its points, or review with “1 in 5 blind”, where you click before you see. Ten repeats of your own give you a click sigma of your own; repeats of other people’s work tell how far people differ.
repeats-no-result = Repeats stand in no list and change no result.
repeats-to-review = Go to the review
repeats-target = target
repeats-items = { $count ->
    [one] { $count } item
   *[other] { $count } items
}

## Repeats: the table of targets

repeats-targets-title = Heights, by target
repeats-targets-note = standard deviations with their 95 % intervals
repeats-targets-help = One spread for near and far vehicles alike, though in millimetres it grows with the distance. Lens, road pose, board and inset are the same for all clicks on a frame and cancel in their differences, so only the clicks’ part of the budgets is compared. On another frame they do not cancel: step to it while you click again.
repeats-clicked-again = clicked again
repeats-same-person = the same person
repeats-another-frame = … on another frame
repeats-another-person = another person adds
repeats-claimed = clicks’ part, claimed
repeats-seen = clicks’ part, seen
repeats-all-targets = all targets
repeats-people-differ = People differ from vehicle to vehicle by more than their own repeats; “the same person” contains that.
repeats-ratio = × { $ratio } ({ $low } to { $high })
repeats-more = more than claimed
repeats-less = less than claimed
repeats-as = as claimed

## Repeats: the table of people

repeats-people-title = Clicks, by person
repeats-people-note = each coordinate of a click, from people’s repeats of their own
repeats-person = person
repeats-own = own repeats
repeats-contact = contact
repeats-height = height
repeats-against-others = against others
repeats-sigma = clicks count with
repeats-sigma-usual = 1 px, as usual
repeats-sigma-own = { $sigma_px } px of their own
repeats-sigma-from = { $count ->
    [one] from { $count } repeat, chosen by { $person }
   *[other] from { $count } repeats, chosen by { $person }
}
repeats-sigma-use = Use { $sigma_px } px
repeats-sigma-use-title = { $count ->
    [one] From { $count } repeat; clicks that are stored keep theirs
   *[other] From { $count } repeats; clicks that are stored keep theirs
}
repeats-sigma-needs = ten own repeats are needed for another
repeats-sigma-back = Back to 1 px

## Repeats: the figure of differences

repeats-differences-title = Second minus first height, over their mean
repeats-differences-note = Each bar is what the budgets of both clicks let one expect (k = 2): about 19 in 20 should reach zero.
repeats-differences-label = { $count ->
    [one] Second minus first height in { $small } over their mean in { $unit }, { $count } repeat
   *[other] Second minus first height in { $small } over their mean in { $unit }, { $count } repeats
}
repeats-differences-x = mean of both heights ({ $unit })
repeats-differences-y = difference ({ $unit })

## Click again: measurements once more, without their points

again-loading = what to click again
again-place = <strong>{ $at } of { $of }</strong> <muted>vehicle { $vehicle }, { $target }</muted>
again-stored = { $count ->
    [one] { $count } repeat stored
   *[other] { $count } repeats stored
}
again-stop = Stop
again-undo = Take the last back
again-undo-clicks = second clicks
again-undo-skip = passing over
again-skip = Pass over
again-results = See what they say
again-back-to-frame = Back to frame { $frame }
again-last-title = That was the last one
again-last = Each was stored as a repeat: it stands in no list and changes no result.
again-none-own-title = You have clicked nothing yet
again-none-title = Nothing is measured yet
again-none-own = How well you repeat yourself shows once you have measured something in this survey.
again-none = Measure some vehicles first; then they can be clicked again.
again-to-measure = Go to measuring

## Statistics: the page

statistics-lead = Errors against known heights, and distributions of what was measured.
statistics-loading = the statistics
statistics-back = Back to the survey
statistics-counted = { $measurements ->
    [one] { $measurements } measurement
   *[other] { $measurements } measurements
} of { $vehicles ->
    [one] { $vehicles } vehicle
   *[other] { $vehicles } vehicles
}, { $roofs ->
    [one] { $roofs } roof
   *[other] { $roofs } roofs
} with a manufacturer’s height.
statistics-left-out = Left out: { $states }.
statistics-left-out-state = { $state ->
    [to_review] { NUMBER($count) } to review
    [reopened] { NUMBER($count) } reopened
    [rejected] { NUMBER($count) } rejected
    [accepted] { NUMBER($count) } accepted
   *[fixed] { NUMBER($count) } fixed
}
statistics-none-accepted-title = No accepted measurements yet
statistics-none-title = No measurements here
statistics-to-review = Go to the review
statistics-show-to-review = Show those to review
statistics-to-measure = Measure vehicles
statistics-none-accepted = { $count ->
    [one] Only accepted measurements count, and { $count } measurement waits for review.
   *[other] Only accepted measurements count, and { $count } measurements wait for review.
}
statistics-none-filtered = The filter leaves no measurement; widen it.
statistics-none = Measure vehicles and have them reviewed; their figures then appear here.
statistics-eye = Driver’s eye
statistics-taillight = Taillight, lower limit
statistics-headlight = Headlight
statistics-roof = Roof

## Statistics: the filter

statistics-filter = Filter
statistics-filter-state = Review state
statistics-filter-state-all = all
statistics-filter-target = Target
statistics-filter-target-all = all
statistics-filter-lighting = Lighting
statistics-filter-category = Category
statistics-filter-any = any
statistics-filter-operator = Operator
statistics-filter-anybody = anybody
statistics-filter-first-day = Measured from (UTC)
statistics-filter-last-day = to
statistics-filter-correction = Correction
statistics-correction-inset = inset of each (default)
statistics-correction-shift = mean error (the paper’s)
statistics-correction-none = none (inset 0)
statistics-correction-regression = regression
statistics-correction-deconvolution = deconvolution
statistics-filter-rounding = Error table
statistics-rounding-cm = whole cm (the paper’s)
statistics-rounding-none = not rounded
statistics-filter-surveys = Surveys
statistics-filter-surveys-some = { $count ->
    [one] { $count } survey
   *[other] { $count } surveys
}
statistics-filter-surveys-none = all surveys
statistics-filter-surveys-help = Surveys that count; none chosen: all
statistics-filter-surveys-clear = All surveys
statistics-reference-u = u of a reference height
statistics-reference-u-hint = as if within ±{ $limit }, all alike
statistics-reference-u-inches = Give a number of inches.
statistics-reference-u-millimetres = Give a number of millimetres.

## Statistics: the error table

statistics-errors-title = Error against manufacturers’ heights
statistics-errors-save = Error table as CSV
statistics-errors-head = error = measured − reference
statistics-bias = bias
statistics-mae = MAE
statistics-rmse = RMSE
statistics-mse = MSE
statistics-sd = SD
statistics-correlation = r(error, height)
statistics-correlation-absolute = r(|error|, height)
statistics-errors-note = Intervals at 95 % below each figure. SD is that of the signed error, n − 1. Not pooled from other figures.
statistics-paper-inconsistent = What is inconsistent in the paper’s printed figures
statistics-paper-note = <strong>{ $group }:</strong> { $note }
statistics-paper-printed = the paper, as printed
statistics-stands-for = stands for { $group }
statistics-no-interval = { $figures }: { $reason }
statistics-reference-part = By itself it makes a correlation of { $correlation } between error and height, which no camera is to blame for (u of the reference { $u_reference }).
statistics-bland-altman = Bland and Altman: bias { $bias } { $unit } ({ $bias_interval }), limits of agreement { $lower } ({ $lower_interval }) and { $upper } { $unit } ({ $upper_interval }), n = { $n }.

## Statistics: the figures of the error

statistics-group-daytime = daytime
statistics-group-low_light = low light
statistics-group-overall = overall
statistics-group-unknown = lighting unknown
statistics-group-n = { $group } n = { $n }
statistics-nothing = Nothing to draw.
statistics-nothing-because = Nothing to draw: { $reason }
statistics-absolute-title = Absolute error, cumulative
statistics-absolute-says = Share of vehicles with an absolute error of at most so much; { $groups }
statistics-absolute-note = Bands at 95 % hold everywhere at once. { $groups }.
statistics-absolute-x = absolute error ({ $unit })
statistics-relative-title = Relative error, cumulative
statistics-relative-says = Share of vehicles with an error of at most so many per cent of their height; { $groups }
statistics-relative-note = Absolute error over the reference height. { $groups }.
statistics-relative-x = relative error (%)
statistics-density-title = Signed error, density
statistics-density-says = Density of the signed error; { $groups }
statistics-density-note = Gaussian kernel, bandwidth { $bandwidths }; pointwise 95 % band. { $groups }.
statistics-density-note-rounded = Gaussian kernel, bandwidth { $bandwidths }, at least half of the { $rounding } of rounding; pointwise 95 % band. { $groups }.
statistics-signed-error = signed error ({ $unit })
statistics-density-y = density (per { $unit })
statistics-trend-title = Signed error against true height
statistics-trend-says = Signed error over the manufacturer's height of { $count ->
    [one] { $count } vehicle
   *[other] { $count } vehicles
}.
statistics-trend-nothing = Nothing to draw: no vehicle has a reference height.
statistics-trend-x = manufacturer’s height ({ $unit })
statistics-trend-legend = regression, 95 % band
statistics-trend = Slope { $slope } { $small } per { $unit } ({ $slope_interval }), r = { $correlation } ({ $correlation_interval }).
statistics-trend-absolute = Absolute error: r = { $correlation } ({ $correlation_interval }).

## Statistics: one target

statistics-heights = { $count ->
    [one] { $count } height
   *[other] { $count } heights
}
statistics-heights-mean = { $count ->
    [one] { $count } height, corrected mean { $mean }
   *[other] { $count } heights, corrected mean { $mean }
}
statistics-heights-mean-sd = { $count ->
    [one] { $count } height, corrected mean { $mean }, SD { $sd }
   *[other] { $count } heights, corrected mean { $mean }, SD { $sd }
}
statistics-curve-raw = as the paper measures
statistics-curve-corrected = corrected
statistics-legend-raw = as the paper measures (inset 0)
statistics-target-ecdf-title = { $target }, cumulative
statistics-target-ecdf-says = Cumulative distribution of { $target } heights as the paper measures them and corrected, { $count ->
    [one] { $count } vehicle
   *[other] { $count } vehicles
}
statistics-target-ecdf-note = Bands at 95 % hold everywhere at once.
statistics-target-ecdf-away = { $count ->
    [one] { $count } standard far outside not drawn.
   *[other] { $count } standards far outside not drawn.
}
statistics-target-nothing = Nothing to draw: no height of this target is left by the filter.
statistics-height-x = height above the road ({ $unit })
statistics-target-density-title = { $target }, density
statistics-target-density-says = Density of corrected { $target } heights
statistics-target-density-note = Corrected heights, Gaussian kernel, pointwise 95 % band.
statistics-share = Share of { $target ->
    [driver_eye] drivers
    [taillight] taillights
   *[headlight] headlights
} below { $height } ({ $standard }): <strong>{ $share }</strong> <muted>({ $low } to { $high }; { NUMBER($below) } of { NUMBER($n) })</muted>
statistics-percentiles = Percentiles, { $target }
statistics-percentiles-save = Percentiles as CSV
statistics-percentile = Percentile
statistics-percentiles-corrected = corrected ({ $unit })
statistics-percentiles-raw = as the paper ({ $unit })
statistics-percentiles-note = 95 % intervals below each value.
statistics-percentiles-without = { $count ->
    [one] Why { $count } percentile has none
   *[other] Why { $count } percentiles have none
}
statistics-percentiles-reason = { $percentiles }: { $reason }.

## Statistics: heights by group

statistics-groups-title = Corrected heights by group
statistics-groups-target = Target
statistics-groups-by = Grouped by
statistics-grouping-category = Category
statistics-grouping-lighting = Lighting
statistics-grouping-site = Site
statistics-grouping-operator = Operator
statistics-groups-head = { $grouping ->
    [category] category
    [lighting] lighting
    [site] site
   *[operator] operator
}
statistics-groups-figure = { $grouping ->
    [category] { $target } by category
    [lighting] { $target } by lighting
    [site] { $target } by site
   *[operator] { $target } by operator
}
statistics-groups-says = Cumulative distributions of { $target } heights by { $grouping ->
    [category] category
    [lighting] lighting
    [site] site
   *[operator] operator
}, { $count ->
    [one] { $count } group
   *[other] { $count } groups
}
statistics-groups-note = The { NUMBER($count) } largest groups of { NUMBER($all) }; the table lists more.
statistics-groups-nothing = { $grouping ->
    [category] Nothing to draw: no vehicle has a category.
    [lighting] Nothing to draw: no vehicle has a lighting.
    [site] Nothing to draw: no vehicle has a site.
   *[operator] Nothing to draw: no vehicle has an operator.
}
statistics-groups-mean = mean ({ $unit })
statistics-groups-sd = SD ({ $unit })

## Statistics: standards

statistics-standards-title = Standards drawn in
statistics-standards-change = Change this survey’s standards
statistics-standards-one-survey = The table belongs to the survey and goes into its package.
statistics-standards-surveys = Each survey has a table of its own; choose one survey to change it.
statistics-standards-address = Ticks and own values are kept in this page’s address.
statistics-standards-loading = the standards
statistics-standard-of-eye = driver’s eye
statistics-standard-of-object = object (taillight, headlight)
statistics-standards-drawn = drawn
statistics-standards-standard = standard
statistics-standards-for = for
statistics-standards-height = height
statistics-standards-source = source
statistics-standards-remove = remove
statistics-standard-draw = Draw { $standard }, { $what }, { $height }
statistics-standard-remove = Remove { $standard }
statistics-standard-own-problem = Give a height above 0 and below 10 m, such as { $example }.
statistics-standard-own = Own value for
statistics-standard-height = Height
statistics-standard-name = Standard
statistics-standard-for = For
statistics-standard-source = Source
statistics-standard-new = New standard
statistics-standard-new-remove = Remove the new standard
statistics-standard-problem = Give the height of { $standard }, such as { $example }.
statistics-standard-new-problem = Give the height of the new standard, such as { $example }.
statistics-standards-add = Add a standard
statistics-standards-save = Save for this survey

## Statistics: how many vehicles to measure

statistics-plan-title = How many vehicles to measure
statistics-plan-percentile = Percentile
statistics-plan-width = Width of its interval
statistics-plan-sd = Spread of heights (SD)
statistics-plan-incomplete = Give three numbers.

## Planning: the page

planning-lead-heights = What a height will be worth from here, before anything is filmed.
planning-lead-lines = What the speed of a vehicle will be worth with two line cameras, before anything is recorded.
planning-nothing-stored = Nothing on this page is stored; its address holds every value, so a link to it can be passed on.
planning-title-lines = Plan the line rate
planning-what = What is planned
planning-what-heights = Heights, by video
planning-what-lines = Speeds, by line scan
planning-loading-cameras = the cameras
planning-loading-rig = the survey's rig
planning-loading = the plan
planning-advice = Advice
planning-lens-exact = The lens is taken as exactly known.
planning-lens-exact-plain = The lens is taken as exactly known, and without distortion.
planning-lens-calibrated = A calibration adds its own uncertainty, most of it away from the board.
planning-roof = Roof
planning-driver_eye = Driver’s eye, near side
planning-driver_eye_far = Driver’s eye, far side
planning-taillight = Taillight
planning-headlight = Headlight

## Planning: what is planned with

planning-width = Picture width
planning-height = Picture height
planning-field-of-view = Horizontal field of view
planning-camera-height = Camera above road
planning-distance = To the wheel track
planning-board-distance = To the board
planning-board-distance-usual = wheel track
planning-direction = Turned along road
planning-sigma = Click sigma
planning-travel = Two-frame travel
planning-camera = Camera
planning-calibration = { $camera }: { $calibration }
planning-calibration-in-use = { $camera }: { $calibration } (in use)
planning-calibration-unknown = calibration { $id }
planning-camera-plain = A camera that is not calibrated yet
planning-number-problem = Give a number.
planning-speed = Fastest vehicle
planning-error = Speed off by
planning-baseline = Baseline
planning-u-baseline = Its u (k = 1)
planning-line-rate = Camera’s line rate
planning-line-rate-usual = what it takes

## Planning: the table of targets

planning-targets-title = What each target will be worth
planning-target = Target
planning-planned-height = planned height
planning-inset = inset
planning-two-frames = U95, two frames
planning-inset-ignored = error, inset ignored
planning-targets-note = Heights and insets are estimates; the survey’s own insets are used. Two frames: the vehicle has moved { $travel } between them, and the inset is solved for instead of assumed.
planning-parts-title = Contributions to u, one frame
planning-parts-label = Contributions to u
planning-parts-source = Source
planning-parts-sum = u, root of the sum of squares

## Planning: figures and drawings

planning-figure-distance-title = U95 of vehicles at other distances
planning-figure-distance-note = One frame; camera, board and pose as planned. A line ends where the picture ends.
planning-figure-distance-label = U95 of vehicles at other distances, U95 in { $small } over distance across the road to the wheel track in { $unit }
planning-figure-distance-x = distance across the road to the wheel track ({ $unit })
planning-figure-distance-y = U95 ({ $unit })
planning-figure-bias-title = Error of a driver’s eye whose inset is ignored
planning-figure-bias-note = It vanishes for a camera at the eye’s height.
planning-figure-bias-label = Error of a driver’s eye whose inset is ignored, error in { $small } over camera above the road in { $unit }
planning-figure-bias-x = camera above the road ({ $unit })
planning-figure-bias-y = error ({ $unit })
planning-figure-bar = The bar marks the planned place.
planning-along-title = The site, seen along the road
planning-along-note = To scale. The wedge is what the picture shows above and below; dots are the targets.
planning-along-label = Cross-section: camera { $camera_height } above the road, board at { $board_distance }, wheel track at { $distance }
planning-above-title = The site from above
planning-above-note = To scale. The picture shows { $shown } of the wheel track with road and a driver’s eye in it.
planning-above-label = From above: the camera looks across the road, square to it, a car in the lane
planning-above-label-turned = { $turned_deg ->
    [one] From above: the camera looks across the road, turned { $turned_deg } degree along the road, a car in the lane
   *[other] From above: the camera looks across the road, turned { $turned_deg } degrees along the road, a car in the lane
}
planning-wheel-track = wheel track { $distance }
planning-wheel-track-and-board = wheel track and board { $distance }
planning-board = board { $distance }

## Planning: the line rate

planning-speed-title = What a speed will be worth
planning-lines = At { $speed } a vehicle takes <strong>{ $lines } lines</strong> from camera 1 to camera 2 at { $line_rate_hz } lines a second, { $one_line } of road a line.
planning-one-line = One line more or less changes its speed by <strong>{ $speed }</strong>.
planning-speed-u = Read to whole lines its standard uncertainty is { $u_lines } from the lines and { $u_baseline } from the baseline: <strong>{ $speed }</strong> in 95 of 100 cases.
planning-forms-title = As printed and as corrected
planning-forms-label = Both forms of equation (2)
planning-forms-equation = equation (2)
planning-forms-printed = as printed: its right side
planning-forms-corrected = corrected: its middle term
planning-forms-error = error of the speed
planning-forms-says = what it says
planning-forms-says-printed = n + 2 lines are counted for n, divided by n + 2. The paper’s own 6600 Hz and 1.3 % come from it.
planning-forms-says-corrected = n + 2 lines are counted for n, divided by n as the middle term 2 s / (b f) is. A little more careful.
planning-forms-line-rate = line rate for { $error }
planning-forms-line-rate-value = { $line_rate_hz } Hz
planning-forms-error-at = error at { $line_rate_hz } Hz
planning-forms-error-value = { $error }, { $speed }
planning-forms-note = n = b f / s: the lines from camera 1 to camera 2, of the baseline b, the line rate f and the speed s.

## Survey: the overview

survey-loading = the survey
survey-demonstration = demonstration
survey-edit = Edit
survey-camera = Calibrate the camera
survey-recordings = Bring in the recordings
survey-pose = Find the road
survey-vehicles = Measure the vehicles
survey-review = Review the measurements
survey-results = Export the results
survey-camera-go = Calibrate
survey-recordings-go = Add recordings
survey-pose-go = Find the road
survey-vehicles-go = Measure
survey-review-go = Review
survey-results-go = Export
survey-open = Open
survey-statistics = <link>Statistics</link>: errors, distributions, percentiles.
survey-scans-none = <link>Line scans</link>: { $summary }
survey-scans-label = Line scans, a way of their own beside these steps
survey-scans = Line scans
survey-scan-results = <link>Results</link>: speeds, gaps, lengths against the makers’.
survey-count-scans = { $count ->
    [one] line scan
   *[other] line scans
}
survey-count-recordings = { $count ->
    [one] recording
   *[other] recordings
}
survey-count-vehicles = { $count ->
    [one] vehicle
   *[other] vehicles
}
survey-count-measured = of { NUMBER($count) } measured
survey-count-measurements = { $count ->
    [one] measurement
   *[other] measurements
}

## Survey: editing it

survey-edit-title = Edit the survey
survey-name = Name
survey-name-problem = A survey needs a name.
survey-site = Site
survey-description = Description
survey-insets = Insets
survey-insets-help = How far each target lies behind the plane through the tyres’ outer faces, away from the camera. Used for every new measurement; the second figure is its standard uncertainty.
survey-insets-target = Target
survey-insets-inset = inset ({ $unit })
survey-insets-u = ± u ({ $unit })
survey-inset-label = { $target }: inset in { $unit ->
    [ft] feet
   *[m] metres
}
survey-inset-u-label = { $target }: uncertainty in { $unit ->
    [ft] feet
   *[m] metres
}
survey-inset-problem = { $target }: give the inset and its uncertainty as numbers in { $unit ->
    [ft] feet
   *[m] metres
}, for example { $inset } and { $u_inset }.

## Survey: photographs of the set-up

photographs-title = Photographs of the set-up
photographs-help = The rig, the road, the board in place. The report and the package show them.
photographs-choose = Choose photographs to add
photographs-drop = Drop photographs here, or choose them
photographs-adding = Adding { $count } …
photographs-hint = JPEG, PNG, WebP or TIFF. Kept at 1600 pixels a side at most, without the place where they were taken.
photographs-open = Open { $photograph }
photographs-what = What it shows
photographs-caption = Caption of { $photograph }
photographs-left = Move { $photograph } to the left
photographs-right = Move { $photograph } to the right
photographs-remove = Take out { $photograph }
photographs-removed = { $photograph } was taken out.

## Surveys: the page

surveys-lead = One survey is one campaign at one site: its camera, recordings, vehicles and people.
surveys-loading = surveys
surveys-new = New survey
surveys-new-make = Make the survey
surveys-new-name = Name
surveys-new-name-example = Rouen south, lane 1
surveys-new-name-problem = Give the survey a name, for example the road and the lane.
surveys-new-site = Site
surveys-new-site-example = D938, km 12.4, towards the south
surveys-new-description = Description
surveys-new-description-hint = What whoever opens it in five years should know.
surveys-choose-password = Choose a password
surveys-link-used = Your sign-in link is used up now; choose a password to be able to come back.
surveys-demo-failed = The demonstration survey could not be made.
surveys-demo-first = The demonstration survey is rendered from a known scene, so every height you measure in it can be compared with the truth. Try the work there first; then make a survey of your own.
surveys-demo-open = Open the demonstration survey
surveys-demo-title = Demonstration survey
surveys-demo-being-made = being made
surveys-demo-wait = Rendering a road, a checkerboard and some forty vehicles; this takes about a minute.
surveys-none-title = No surveys yet
surveys-none-make = Make a survey for a site, then calibrate its camera, drop in the day's video, and measure. The demonstration survey has all of that in it already.
surveys-none = Nobody has made a survey yet. An operator can make the first one.
surveys-card = <made>{ $recordings ->
    [one] { $recordings } recording
   *[other] { $recordings } recordings
} · { $day }</made>
surveys-card-with-site = { $site } · <made>{ $recordings ->
    [one] { $recordings } recording
   *[other] { $recordings } recordings
} · { $day }</made>
surveys-vehicles-measured = Vehicles measured
surveys-heights-reviewed = Heights reviewed
surveys-scans-reviewed = Scans reviewed
surveys-scans = Line scans: { $summary }
surveys-all-done = All steps done
surveys-tally = { NUMBER($done) } <muted>of { NUMBER($all) }</muted>

## Sign in: the page

signin-loading = your account
signin-link-title = Your sign-in link
signin-with-password = Sign in with a password
signin-email = E-mail
signin-password = Password
signin-submit = Sign in
signin-help = No password yet? Use the one-time link: the server prints it when it first starts, and an administrator makes one for each new person.

## Account: the page

account-name = Name
account-email = E-mail
account-role = Role
account-password-change = Change the password
account-password-choose = Choose a password
account-no-password = You have no password yet; without one you need a new link for each sign-in.
account-password-present = Present password
account-password-new = New password
account-password-hint = At least { NUMBER($least) } characters; a few words in a row are easy to keep in mind.
account-password-short = { $count ->
    [one] That has { $count } character; at least { NUMBER($least) } are needed.
   *[other] That has { $count } characters; at least { NUMBER($least) } are needed.
}
account-password-again = The same again
account-password-differs = The two are not the same; type the new password twice.
account-password-set = Set the password
account-password-is-set = Your password is set.

## People: the page

people-only-admin = Only an administrator can see and change accounts; ask one if you need another role.
people-lead = Who may do what. Nobody reviews their own work, whatever their role.
people-loading = people
people-add = Add a person
people-name = name
people-email = e-mail
people-role = role
people-state = state
people-last-seen = last sign-in
people-actions = actions
people-you = (you)
people-role-of = Role of { $person }
people-no-password = no password yet
people-never = never
people-new-link = New link
people-switch-off = Switch off
people-switch-on = Switch on
people-switch-off-title = Switch off { $person }?
people-switch-off-body = They are signed out and cannot sign in again; what they measured and reviewed stays under their name.
people-does-viewer = sees everything, exports packages
people-does-operator = brings in recordings, calibrates, measures
people-does-reviewer = what an operator does, and reviews the work of others
people-does-admin = everything, and people

## People: adding one

people-add-action = Add
people-add-name = Name
people-add-name-problem = Give the person's name as it should appear beside their work.
people-add-email = E-mail
people-add-email-hint = They sign in with it. Sightline sends no mail: you pass on the link that comes next.
people-add-email-problem = Give an e-mail address, for example ada@example.org.
people-add-role = Role
people-link-title = Sign-in link for { $person }
people-link-help = Pass this on to { $person }. It works once, for seven days, and is shown only now.
people-link = Sign-in link
people-link-copy = Copy the link
people-link-copied = The link is on the clipboard.
people-link-done = Done

## Audit: the page

audit-title = Audit trail
audit-lead = One event per write, chained by hash: nothing here can be changed or removed without the chain showing it.
audit-loading = the audit trail
audit-survey = Survey
audit-survey-all = All
audit-what = What was changed
audit-what-all = Everything
audit-none-title = No events here
audit-none-filtered = Nothing matches these filters; widen them.
audit-none = Nothing has been written yet.
audit-events = Audit events
audit-number = no.
audit-when = when
audit-who = who
audit-did = did
audit-changes = changes
audit-hash = hash
audit-older = Show older events
audit-hash-after = { $hash }, after { $previous }
audit-hash-first = { $hash }, after nothing
audit-check = Check the chain
audit-whole-title = The chain is whole
audit-whole = { $count ->
    [one] { $count } event checked; the last hash is <code>{ $hash }</code>.
   *[other] { $count } events checked; the last hash is <code>{ $hash }</code>.
}
audit-broken-title = The chain is broken

## Audit: what was done, and to what

audit-action-calibrate = calibrate
audit-action-cancel = cancel
audit-action-cancelled = cancelled
audit-action-check_drift = check drift
audit-action-choose = choose
audit-action-choose_calibration = choose calibration
audit-action-create = create
audit-action-decide_drift = decide drift
audit-action-delete = delete
audit-action-detect = detect
audit-action-done = done
audit-action-failed = failed
audit-action-finish = finish
audit-action-fix = fix
audit-action-import = import
audit-action-ingest = ingest
audit-action-ingest_failed = ingest failed
audit-action-order = order
audit-action-read = read
audit-action-reading_failed = reading failed
audit-action-release = release
audit-action-requeue = requeue
audit-action-restart_ingest = restart ingest
audit-action-restart_reading = restart reading
audit-action-restore = restore
audit-action-review = review
audit-action-revise = revise
audit-action-run = run
audit-action-set_password = set password
audit-action-sign_out = sign out
audit-action-swap_cameras = swap cameras
audit-action-take_back_drift_decision = take back drift decision
audit-action-update = update
audit-action-use = use
audit-action-withdraw = withdraw
audit-entity-survey = survey
audit-entity-camera = camera
audit-entity-calibration_image = calibration image
audit-entity-calibration = calibration
audit-entity-recording = recording
audit-entity-upload = upload
audit-entity-pose = pose
audit-entity-photograph = photograph
audit-entity-catalogue = catalogue
audit-entity-vehicle = vehicle
audit-entity-measurement = measurement
audit-entity-review = review
audit-entity-wheel_pair = wheel pair
audit-entity-click_sigma = click sigma
audit-entity-standards = standards
audit-entity-scan = scan
audit-entity-scan_run = scan run
audit-entity-scan_vehicle = scan vehicle
audit-entity-scan_measurement = scan measurement
audit-entity-scan_review = scan review
audit-entity-line_pose = line pose
audit-entity-line_height = line height
audit-entity-export = export
audit-entity-person = person
audit-entity-sign_in_link = sign in link
audit-entity-job = job
audit-entity-id = { $entity } { $id }

## Export: the page

export-lead = A zip file with everything needed to check each height, and to compute it again.
export-crops = with pictures of the clicks
export-build = Build the package
export-ready = The package is ready.
export-failed = The package could not be built; try again.
export-open-to-review = { $to_review ->
    [one] { $to_review } measurement not yet reviewed.
   *[other] { $to_review } measurements not yet reviewed.
}
export-open-rejected = { $rejected ->
    [one] { $rejected } measurement rejected and not clicked again.
   *[other] { $rejected } measurements rejected and not clicked again.
}
export-open-both = { $to_review ->
    [one] { $to_review } measurement not yet reviewed
   *[other] { $to_review } measurements not yet reviewed
}, { $rejected ->
    [one] { $rejected } measurement rejected and not clicked again.
   *[other] { $rejected } measurements rejected and not clicked again.
}
export-open-note = The package says so, row by row; <link>review first</link> if it is to be final.
export-packages = Packages
export-loading = packages
export-none-title = No package yet
export-none = Press “Build the package”. It takes from seconds to minutes, with the number of pictures, and you can go on working meanwhile.
export-made = made
export-by = by
export-size = size
export-sha256 = SHA-256
export-audit-head = head of the audit chain
export-download-column = download
export-download = Download
export-sha256-copy = Copy the SHA-256
export-sha256-copied = The SHA-256 is on the clipboard.
export-audit-head-copy = Copy the head of the audit chain
export-audit-head-copied = The head of the audit chain is on the clipboard.
export-checking = Checking a package
export-checking-help = This checks every file, the audit chain and each row against it, and computes every height and every statistic again. Send the head of the audit chain and the SHA-256 by another way than the package: they find a package that was written anew from end to end.
export-command-copy = Copy the command
export-command-copied = The command is on the clipboard.

## Export: what is in a package

export-contents = What is in a package
export-contents-report = a few pages for people: set-up, calibration, method, errors, figures, exclusions
export-contents-measurements = each measurement as it stands: vehicle, target, frame, height and its uncertainty
export-contents-exclusions = what counts for no result, and why
export-contents-statistics = error table, percentiles, distributions and corrections as CSV; figures as SVG
export-contents-crops = the picture that each click was made on, unmarked, and with its points beside it
export-contents-revisions = every revision with its clicks, and where its uncertainty comes from
export-contents-clicks = the clicks alone: “sightline height” computes the same heights from them
export-contents-vehicles = make, model, year, manufacturer height and its source, lighting
export-contents-recordings = file hashes, and the time stamp and checksum of each frame measured on
export-contents-poses = where the camera stood and what its lens does, as tables and as JSON
export-contents-insets = insets in force; both tyres of a vehicle, for its direction of travel
export-contents-reviews = who accepted, fixed or rejected what, and why; what was clicked again
export-contents-audit = each change with its hash; the chain can be checked
export-contents-datapackage = name, unit and meaning of every column (Frictionless Data)
